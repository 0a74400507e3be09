#include "widgets/fuzzy/rule_strengths.h"

#include "core/fuzzy/rule_text.h"
#include "widgets/fuzzy/small_font.h"
#include "widgets/fuzzy/term_scale.h"
#include "widgets/inputs/number_text.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>

#include <algorithm>
#include <numeric>

namespace esm {

namespace {

constexpr int rowMargin = 4, wordMargin = 6, degreeWidth = 40; // pixels
constexpr int wrappedWords = Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap;

QString strengthText(std::optional<double> degree) {
    return degree ? decimalText(*degree, 2) : QString(QChar(0x2013));
}

/// As people read it; keywords stay in capitals.
QString wordsOfRule(const FuzzySystem& system, const FuzzyRule& rule) {
    return readableName(ruleText(system, rule));
}

} // namespace

RuleStrengths::RuleStrengths(QWidget* parent) : QAbstractScrollArea(parent) {
    setObjectName(QStringLiteral("ruleStrengths"));
    setAccessibleName(tr("How strongly each rule fires"));
    setToolTip(tr("Click a rule, or choose one with the arrow keys, to see how its degree comes about"));
    setFrameShape(QFrame::NoFrame);
    setFont(smallFont(font()));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    viewport()->setAutoFillBackground(false);
}

void RuleStrengths::setSystem(std::shared_ptr<const FuzzySystem> system) {
    const QString chosen = m_chosen ? m_words[*m_chosen] : QString();
    m_system = std::move(system);
    m_words.clear();
    m_rules.clear();
    if (m_system)
        for (const FuzzyRule& rule : m_system->rules)
            m_words.push_back(wordsOfRule(*m_system, rule));
    m_rules.resize(m_words.size());
    // What stands there now may be another rule.
    if (m_chosen && (*m_chosen >= m_words.size() || m_words[*m_chosen] != chosen)) choose(std::nullopt);
    measure();
}

void RuleStrengths::setExplanations(std::vector<RuleExplanation> rules) {
    m_rules = std::move(rules);
    arrange();
    tellSpoken(*this);
}

QString RuleStrengths::spokenValue() const {
    return m_chosen ? explained(*m_chosen) : tr("%1 rules, none chosen").arg(m_words.size());
}

void RuleStrengths::setStrongestFirst(bool on) {
    m_strongestFirst = on;
    verticalScrollBar()->setValue(0);
    arrange();
}

QString RuleStrengths::explained(std::size_t rule) const {
    const RuleExplanation& explanation = m_rules[rule];
    QStringList lines{m_words[rule]};
    for (const PropositionDegree& part : explanation.propositions) {
        const FuzzyVariable& input = m_system->inputs[part.proposition.variable];
        const QString term = QString::fromStdString(input.terms[part.proposition.term].name);
        const QString what = part.degree ? strengthText(part.degree) : tr("its value is left out");
        lines << readableName(
            tr("%1 is %2: %3").arg(QString::fromStdString(input.name), term, what).toStdString());
    }
    const double weight = m_system->rules[rule].weight;
    if (!explanation.condition)
        lines << tr("It does not fire, since it asks for a value that is left out.");
    else if (weight == 1)
        lines << tr("It fires to the degree %1.").arg(strengthText(explanation.firing));
    else
        lines << tr("Its condition holds to the degree %1; times its weight, %2, it fires to %3.")
                     .arg(strengthText(explanation.condition), numberText(weight, 2),
                          strengthText(explanation.firing));
    return lines.join('\n');
}

QRect RuleStrengths::wordsIn(const QRect& row) const {
    return row.adjusted(wordMargin, 0, -degreeWidth - wordMargin, 0);
}

void RuleStrengths::measure() {
    m_heights.clear();
    const int width = wordsIn(viewport()->rect()).width();
    const QFontMetrics metrics(font());
    for (const QString& words : m_words)
        m_heights.push_back(2 * rowMargin +
                            metrics.boundingRect(QRect(0, 0, width, 1 << 20), wrappedWords, words).height());
    arrange();
}

void RuleStrengths::arrange() {
    m_order.resize(m_words.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    if (m_strongestFirst)
        std::stable_sort(m_order.begin(), m_order.end(),
                         [&](std::size_t a, std::size_t b) { return m_rules[a].firing > m_rules[b].firing; });
    m_tops.assign(1, 0);
    for (const std::size_t rule : m_order)
        m_tops.push_back(m_tops.back() + m_heights[rule] + 1);
    verticalScrollBar()->setRange(0, std::max(0, m_tops.back() - viewport()->height()));
    verticalScrollBar()->setPageStep(viewport()->height());
    verticalScrollBar()->setSingleStep(QFontMetrics(font()).height());
    viewport()->update();
}

void RuleStrengths::drawRule(QPainter& painter, std::size_t rule, const QRect& row) const {
    const double firing = m_rules[rule].firing;
    QColor bar = palette().color(QPalette::Link);
    bar.setAlphaF(0.28);
    QRectF filled(row);
    filled.setWidth(firing * row.width());
    painter.fillRect(filled, bar);
    if (rule == m_chosen) {
        painter.setPen(palette().color(QPalette::Link));
        painter.drawRect(row.adjusted(0, 0, -1, -1));
    }
    painter.setPen(palette().color(firing > 0 ? QPalette::WindowText : QPalette::PlaceholderText));
    painter.drawText(wordsIn(row), wrappedWords, m_words[rule]);
    QFont strong = font();
    strong.setBold(firing > 0);
    painter.setFont(strong);
    painter.drawText(row.adjusted(0, 0, -wordMargin, 0), Qt::AlignRight | Qt::AlignVCenter,
                     strengthText(m_rules[rule].condition ? std::optional(firing) : std::nullopt));
    painter.setFont(font());
}

void RuleStrengths::paintEvent(QPaintEvent*) {
    QPainter painter(viewport());
    painter.fillRect(viewport()->rect(), palette().color(QPalette::Base));
    painter.setFont(font());
    const int scrolled = verticalScrollBar()->value();
    const auto first = std::upper_bound(m_tops.begin(), m_tops.end(), scrolled) - m_tops.begin() - 1;
    for (auto place = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, first));
         place < m_order.size() && m_tops[place] - scrolled < viewport()->height(); ++place)
        drawRule(painter, m_order[place],
                 {0, m_tops[place] - scrolled, viewport()->width(), m_heights[m_order[place]]});
}

void RuleStrengths::resizeEvent(QResizeEvent* event) {
    if (event->size().width() != event->oldSize().width())
        measure();
    else
        arrange();
}

std::optional<std::size_t> RuleStrengths::ruleAt(int y) const {
    const int place = y + verticalScrollBar()->value();
    if (place < 0 || place >= m_tops.back()) return std::nullopt;
    const auto next = std::upper_bound(m_tops.begin(), m_tops.end(), place);
    return m_order[static_cast<std::size_t>(next - m_tops.begin() - 1)];
}

std::optional<std::size_t> RuleStrengths::placeOfChosen() const {
    if (!m_chosen) return std::nullopt;
    return static_cast<std::size_t>(std::find(m_order.begin(), m_order.end(), *m_chosen) - m_order.begin());
}

void RuleStrengths::choose(std::optional<std::size_t> rule) {
    if (rule == m_chosen) return;
    m_chosen = rule;
    tellSpoken(*this);
    viewport()->update();
    emit ruleChosen();
}

void RuleStrengths::bringIntoView(std::size_t place) {
    QScrollBar* bar = verticalScrollBar();
    const int top = m_tops[place], bottom = m_tops[place + 1];
    bar->setValue(std::clamp(bar->value(), bottom - viewport()->height(), top));
}

void RuleStrengths::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    const auto rule = ruleAt(event->y());
    choose(rule == m_chosen ? std::nullopt : rule);
}

void RuleStrengths::keyPressEvent(QKeyEvent* event) {
    const bool isUp = event->key() == Qt::Key_Up, isDown = event->key() == Qt::Key_Down;
    if (event->key() == Qt::Key_Escape && m_chosen) return choose(std::nullopt);
    if ((!isUp && !isDown) || m_order.empty()) return QAbstractScrollArea::keyPressEvent(event);
    const auto at = placeOfChosen();
    std::size_t place = at.value_or(0);
    if (at && isUp && place > 0) --place;
    if (at && isDown && place + 1 < m_order.size()) ++place;
    choose(m_order[place]);
    bringIntoView(place);
}

void RuleStrengths::focusInEvent(QFocusEvent* event) {
    QAbstractScrollArea::focusInEvent(event);
    if (event->reason() != Qt::MouseFocusReason && !m_chosen && !m_order.empty()) choose(m_order.front());
}

bool RuleStrengths::viewportEvent(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QAbstractScrollArea::viewportEvent(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const auto rule = ruleAt(help->y()))
        QToolTip::showText(help->globalPos(), explained(*rule), viewport());
    else
        QToolTip::showText(help->globalPos(), toolTip(), viewport());
    return true;
}

} // namespace esm
