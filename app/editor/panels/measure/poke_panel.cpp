#include "app/editor/panels/measure/poke_panel.h"

#include "app/editor/dialogs/sentence.h"
#include "app/editor/workers/pulled_scene.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quiet_label.h"
#include "widgets/inputs/section.h"

#include <QHBoxLayout>

#include <algorithm>

namespace esm {

namespace {

QString secondsText(double seconds) {
    return decimalText(seconds, 1) + QStringLiteral(" s");
}

/// The largest of a quantity in a motion, in a unit; none without a motion.
std::optional<double> largest(const PokeTest::Motion& motion, double PokePicture::*quantity, double unit) {
    if (!motion) return std::nullopt;
    double most = 0;
    for (const PokePicture& picture : motion->pictures)
        most = std::max(most, picture.*quantity);
    return most / unit;
}

} // namespace

PokePanel::PokePanel(PokeTest& test, QWidget* parent)
    : QWidget(parent), m_test(test), m_record(new QPushButton(tr("Record"), this)),
      m_repeat(new QPushButton(tr("Repeat"), this)), m_cancel(new QPushButton(tr("Cancel"), this)),
      m_makeScene(new QPushButton(tr("Make the pull the scene"), this)),
      m_news(new WorkNews(QStringLiteral("poke"), tr("How much of the motion is computed"), this)),
      m_figures(new FigureTable(this)) {
    auto* poke = new Section(tr("Poke"), this);
    poke->body()->addWidget(buildRecording());
    poke->body()->addWidget(buildButtons());
    m_makeScene->setObjectName(QStringLiteral("makePokeScene"));
    m_makeScene->setAutoDefault(true);
    connect(m_makeScene, &QPushButton::clicked, this, &PokePanel::sceneAsked);
    poke->body()->addWidget(m_makeScene);
    poke->body()->addWidget(m_news);
    auto* met = new Section(tr("What it met"), this);
    m_figures->addRow(tr("Largest force, N"), QStringLiteral("pokeForce"),
                      tr("Of the tissue on what pulls or pushes it, a mean over a moment"));
    m_figures->addRow(tr("Largest displacement, mm"), QStringLiteral("pokeDisplacement"),
                      tr("Of the tissue that is pulled or pushed, from where it rests"));
    m_figures->addRow(tr("Force at the moment shown, N"), QStringLiteral("pokeForceShown"),
                      tr("While a moment of the motion is watched"));
    met->body()->addWidget(m_figures);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(poke);
    column->addWidget(met);

    connect(&m_test, &PokeTest::changed, this, &PokePanel::refresh);
    connect(&m_test.player(), &PokePlayer::changed, this, &PokePanel::showMoment);
    refresh();
}

QWidget* PokePanel::buildRecording() {
    auto* whole = new QWidget(this);
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    QLabel* said = quietLabel(tr("Records what your hand does to the organ with the tools Pull and "
                                 "Instrument, and does the same to the organ as you change it."),
                              whole);
    said->setWordWrap(true);
    column->addWidget(said);
    m_record->setObjectName(QStringLiteral("recordPoke"));
    m_record->setAutoDefault(true); // Enter works where it has the keys
    column->addWidget(m_record);
    auto* rows = new ValueRows(whole);
    m_length = rows->addText(tr("Length"), QStringLiteral("pokeLength"));
    m_length->setToolTip(tr("In the tissue's own time, which passes slowly where an organ is large"));
    column->addWidget(rows);
    connect(m_record, &QPushButton::clicked, this, [this] {
        if (m_test.isRecording())
            m_test.stop();
        else
            m_test.record();
    });
    return whole;
}

QWidget* PokePanel::buildButtons() {
    auto* whole = new QWidget(this);
    auto* row = new QHBoxLayout(whole);
    row->setContentsMargins(0, 0, 0, 0);
    m_repeat->setObjectName(QStringLiteral("repeatPoke"));
    m_repeat->setAutoDefault(true);
    m_cancel->setObjectName(QStringLiteral("cancelPoke"));
    row->addWidget(m_repeat, 2);
    row->addWidget(m_cancel, 1);
    connect(m_repeat, &QPushButton::clicked, &m_test, &PokeTest::repeat);
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        m_repeat->setFocus(); // since the button cannot be used any more
        m_test.cancel();
    });
    return whole;
}

void PokePanel::refresh() {
    const bool isRecording = m_test.isRecording();
    m_record->setText(isRecording ? tr("Stop") : tr("Record"));
    m_record->setToolTip(isRecording ? tr("End the recording, and compute the motion")
                                     : tr("Bring the organ to rest and record what your hand does to it, "
                                          "for up to %1 s")
                                           .arg(longestPoke));
    const QString none = tr("none yet");
    m_length->setText(isRecording     ? secondsText(m_test.recordedTime())
                      : m_test.poke() ? secondsText(m_test.poke()->duration)
                                      : none);
    const QString obstacle = m_test.obstacle();
    enable(m_repeat, obstacle.isEmpty(), tr("Do the same to the organ as it is now"), obstacle);
    enableMakingScene();
    enable(m_cancel, m_test.isComputing(), tr("Stop computing; the motion before stays"),
           tr("Nothing is being computed"));
    showFigures();
    showNews();
}

void PokePanel::enableMakingScene() {
    const bool canBeScene = m_test.poke() && hasPull(*m_test.poke()) && !m_test.isRecording();
    enable(
        m_makeScene, canBeScene,
        tr("The first pull, from rest until you let go, then moves the organ in Play scene, where speed "
           "and accuracy are measured, and in other programs; it is saved with the project"),
        m_test.isRecording() ? tr("End the recording first")
        : m_test.poke()
            ? tr("Only a pull of 0.1 s or more can be the scene, and none was recorded: what the instrument "
                 "pushes cannot")
            : tr("Record a pull first"));
}

void PokePanel::showFigures() {
    showMoment();
    if (m_shown == m_test.latest() && m_shownBefore == m_test.former()) return;
    m_shown = m_test.latest();
    m_shownBefore = m_test.former();
    constexpr double millimetre = 1e-3;
    m_figures->setRow(0, largest(m_shown, &PokePicture::force, 1),
                      largest(m_shownBefore, &PokePicture::force, 1));
    m_figures->setRow(1, largest(m_shown, &PokePicture::displacement, millimetre),
                      largest(m_shownBefore, &PokePicture::displacement, millimetre));
}

void PokePanel::showMoment() {
    const auto forceIn = [&](const PokeTest::Motion& motion) -> std::optional<double> {
        if (!motion || !m_test.player().isShown()) return std::nullopt;
        return pictureAt(*motion, m_test.player().time()).force;
    };
    m_figures->setRow(2, forceIn(m_test.latest()), forceIn(m_test.former()));
}

void PokePanel::showNews() {
    const bool isComputing = m_test.isComputing();
    m_news->setProgress(isComputing ? std::optional(m_test.progress()) : std::nullopt);
    const QString failure = isComputing ? QString() : sentence(m_test.failure());
    const bool endsEarly = m_test.latest() && !m_test.latest()->failure.empty();
    const bool warns = !failure.isEmpty() || m_test.isOutdated() || endsEarly;
    m_news->say(failure.isEmpty() ? remark() : failure, warns && !m_test.isRecording());
}

/// What else should be known, the most needed first.
QString PokePanel::remark() const {
    if (m_test.isRecording())
        return tr("Recording: pull or push the organ in the view, let it come to rest, then Stop.");
    const PokeTest::Motion& latest = m_test.latest();
    if (!latest) return {};
    if (m_test.isOutdated()) return tr("Computed before the last change of the organ: repeat it.");
    if (!latest->failure.empty())
        return tr("The motion ends early: %1").arg(QString::fromStdString(latest->failure));
    return {};
}

} // namespace esm
