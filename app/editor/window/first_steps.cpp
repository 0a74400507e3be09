#include "app/editor/window/first_steps.h"

#include <QVariant>

#include <algorithm>

namespace esm {

namespace {

constexpr int lookEvery = 100; // ms

/// The slider of the region that was added last.
QString sliderHint(const Project& project) {
    const QString begin =
        FirstSteps::tr("Drag the region where you want it; its handles size and turn it. Then say "
                       "how its tissue is: ");
    const auto& regions = project.regions;
    if (regions.empty() || !regions.back().system || regions.back().system->inputs.empty())
        return begin + FirstSteps::tr("move a slider at the right.");
    const FuzzyVariable& input = regions.back().system->inputs.front();
    return begin +
           FirstSteps::tr("move the slider “%1” at the right.").arg(QString::fromStdString(input.name));
}

bool haveOtherWords(const Project& before, const Project& now) {
    return std::any_of(now.regions.begin(), now.regions.end(), [&](const Region& region) {
        const Region* former = findPart(before.regions, region.id);
        return former && (former->inputs != region.inputs || !(former->held == region.held));
    });
}

} // namespace

FirstSteps::FirstSteps(QWidget& view, Document& document, Preview& preview)
    : QObject(&view), m_document(document), m_preview(preview), m_notice(new ViewNotice(view)),
      m_steps(makeSteps()) {
    m_notice->setProperty("hint", true);
    m_timer.setInterval(lookEvery);
    connect(&m_timer, &QTimer::timeout, this, &FirstSteps::look);
    connect(&preview, &Preview::pullBegan, this, [this] {
        ++m_pulls;
        if (m_timer.isActive()) look();
    });
    connect(m_notice, &ViewNotice::dismissed, this, &FirstSteps::end);
    connect(m_notice, &ViewNotice::helpAsked, this, [this] { show(m_step + 1); });
}

std::vector<FirstSteps::Step> FirstSteps::makeSteps() {
    const auto saying = [](const QString& text) { return [text](const Project&) { return text; }; };
    return {
        {saying(tr(
             "Pull at the tissue: drag on the organ with the left mouse button. The right button turns the "
             "view, the wheel comes closer.")),
         [this] { return m_pulls > 0; }},
        {saying(
             tr("Mark a region with tissue of its own: “+ add” beside Regions lays one on the surface in the "
                "middle of the view.")),
         [this] { return m_document.project().regions.size() > m_before->regions.size(); }},
        {sliderHint, [this] { return haveOtherWords(*m_before, m_document.project()); }},
        {saying(tr("Feel the difference: take the tool Pull and pull at the region, then beside it.")),
         [this] { return m_pulls > 1; }},
        {saying(tr("Hand the organ over: Export writes the model package that simulators load. The menu File "
                   "keeps the project.")),
         [this] { return m_isHandedOver; }}};
}

void FirstSteps::begin() {
    m_isHandedOver = false;
    m_timer.start();
    show(0);
}

void FirstSteps::end() {
    m_timer.stop();
    m_notice->hide();
}

void FirstSteps::show(std::size_t step) {
    if (step >= m_steps.size()) return end();
    m_step = step;
    m_before = std::make_shared<const Project>(m_document.project());
    m_pulls = 0;
    const bool isLast = step + 1 == m_steps.size();
    m_notice->say(
        tr("%1 of %2. %3").arg(step + 1).arg(m_steps.size()).arg(m_steps[step].textFor(m_document.project())),
        isLast ? tr("Done") : tr("Next"), tr("Skip this hint"));
}

void FirstSteps::look() {
    if (m_steps[m_step].isDone()) show(m_step + 1);
}

} // namespace esm
