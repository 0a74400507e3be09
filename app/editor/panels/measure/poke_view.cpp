#include "app/editor/panels/measure/poke_view.h"

#include "app/editor/panels/measure/measurement_file.h"
#include "app/editor/panels/measure/poke_files.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"

#include <QSignalBlocker>
#include <QVBoxLayout>

namespace esm {

namespace {

ChartCurve forceOverTime(const QString& name, const PokeMotion& motion) {
    ChartCurve curve{name, {}};
    for (const PokePicture& picture : motion.pictures)
        curve.points.push_back({picture.time, picture.force});
    return curve;
}

std::vector<NamedMotion> namedMotions(const PokeTest& test) {
    std::vector<NamedMotion> motions{{"now", test.latest()}};
    if (test.former() && test.former() != test.latest()) motions.push_back({"before", test.former()});
    return motions;
}

} // namespace

PokeView::PokeView(Document& document, PokeTest& test, QWidget* parent)
    : QWidget(parent), m_document(document), m_test(test),
      m_header(new ComparisonHeader(QStringLiteral("Poke"), this)),
      m_film(new QPushButton(tr("Save film…"), this)), m_watch(new QPushButton(tr("Watch"), this)),
      m_leave(new QPushButton(tr("Living organ"), this)), m_moment(new ValueSlider(this)),
      m_time(new QLabel(this)), m_chart(new CurveChart(this)) {
    setObjectName(QStringLiteral("pokeView"));
    setAttribute(Qt::WA_StyledBackground);
    m_chart->setObjectName(QStringLiteral("pokeChart"));
    m_chart->setAxes({tr("time"), QStringLiteral("s")}, {tr("force"), QStringLiteral("N")});
    m_chart->setToolTip(
        tr("The force on what pokes, over time; the arrow keys go from one moment to the next"));
    m_chart->setEmptyText(tr("No poke yet. Record, then pull or push the organ: here its force is drawn over "
                             "time, and beside it what it is after you change the tissue."));
    m_header->setTitle(tr("Force over time"));
    m_film->setObjectName(QStringLiteral("saveFilm"));
    m_header->addButton(m_film);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 12);
    column->setSpacing(8);
    column->addWidget(m_header);
    column->addLayout(buildPlayer());
    column->addWidget(m_chart, 1);
    connectHeader();
    connect(&m_test, &PokeTest::changed, this, &PokeView::refresh);
    connect(&m_test.player(), &PokePlayer::changed, this, &PokeView::showMoment);
    refresh();
}

void PokeView::connectHeader() {
    connect(m_header, &ComparisonHeader::keepAsked, &m_test, &PokeTest::keepLatest);
    connect(m_header, &ComparisonHeader::clearAsked, &m_test, &PokeTest::forgetFormer);
    connect(m_header, &ComparisonHeader::tableAsked, this, [this] {
        tell(saveTable(window(), m_document, [this] { return pokeCsv(namedMotions(m_test)); }));
    });
    connect(m_header, &ComparisonHeader::chartAsked, this, [this] {
        tell(saveChart(window(), m_document, [this] { return pokeChart(namedMotions(m_test)); }));
    });
    connect(m_film, &QPushButton::clicked, this, &PokeView::filmAsked);
}

void PokeView::tell(const QString& written) {
    if (!written.isEmpty()) emit message(written);
}

QLayout* PokeView::buildPlayer() {
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    m_watch->setObjectName(QStringLiteral("watchPoke"));
    m_leave->setObjectName(QStringLiteral("leavePoke"));
    m_moment->setObjectName(QStringLiteral("pokeMoment"));
    m_moment->setOrientation(Qt::Horizontal);
    m_moment->setAccessibleName(tr("Moment that is shown"));
    m_time->setObjectName(QStringLiteral("pokeTime"));
    m_time->ensurePolished();
    m_time->setMinimumWidth(m_time->fontMetrics().horizontalAdvance(QStringLiteral("00.00 of 00.00 s")));
    m_time->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_watch->setMinimumWidth(m_watch->fontMetrics().horizontalAdvance(tr("Watch") + tr("Pause")));
    for (QPushButton* button : {m_watch, m_leave})
        button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(m_watch);
    row->addWidget(m_moment, 1);
    row->addWidget(m_time);
    row->addWidget(m_leave);
    PokePlayer& player = m_test.player();
    connect(m_watch, &QPushButton::clicked, &player, [this, &player] {
        m_watch->setFocus(); // so that the space bar pauses, and does not press what was pressed before
        if (player.isPlaying())
            player.pause();
        else
            player.play();
    });
    connect(m_leave, &QPushButton::clicked, &player, &PokePlayer::leave);
    connect(m_moment, &QSlider::valueChanged, &player, [&player](int picture) {
        player.showMoment(static_cast<double>(picture) / pokePicturesPerSecond);
    });
    return row;
}

void PokeView::refresh() {
    const PokeTest::Motion &now = m_test.latest(), &before = m_test.former();
    const QString none = tr("Nothing is recorded yet");
    m_header->setState({now != nullptr, now != before, before != nullptr},
                       {tr("Compare every later motion with this one, also of another poke"),
                        tr("Show the last motion alone"),
                        tr("Write times, forces and displacements as a table (.csv)"),
                        tr("This motion is the one that the next is compared with"),
                        tr("There is no earlier motion beside this one"), none});
    if (now != m_shown || before != m_shownBefore) showMotions();
    showMoment();
}

void PokeView::showMotions() {
    m_shown = m_test.latest();
    m_shownBefore = m_test.former();
    std::vector<ChartCurve> curves;
    if (m_shown) curves.push_back(forceOverTime(tr("now"), *m_shown));
    if (m_shown && m_shownBefore && m_shownBefore != m_shown)
        curves.push_back(forceOverTime(tr("before"), *m_shownBefore));
    m_chart->setCurves(std::move(curves));
}

void PokeView::showMoment() {
    const PokePlayer& player = m_test.player();
    const bool canShow = player.duration() > 0;
    const QString none =
        m_shown ? tr("The organ has other nodes now: repeat the poke") : tr("Record a poke first");
    enable(m_film, canShow, tr("Write the motion as a film (.avi), or its pictures (.png), seen as now"),
           none);
    m_watch->setText(player.isPlaying() ? tr("Pause") : tr("Watch"));
    enable(m_watch, canShow,
           player.isPlaying() ? tr("Stay at this moment")
                              : tr("Show the motion at its own speed, beside the one before"),
           none);
    enable(m_moment, canShow, tr("Show a moment of the motion"), none);
    enable(m_leave, player.isShown(), tr("Show the organ that you can touch again"),
           tr("The living organ is shown"));
    const QSignalBlocker blocker(m_moment);
    m_moment->setMaximum(qRound(player.duration() * pokePicturesPerSecond));
    m_moment->setScale(0, player.duration());
    m_moment->setValue(pictureNumberAt(player.time()));
    m_time->setText(
        canShow ? tr("%1 of %2 s").arg(decimalText(player.time(), 2), decimalText(player.duration(), 2))
                : QString());
    m_moment->setSpoken(canShow ? m_time->text() : tr("no motion"));
    m_chart->setMoment(player.isShown() ? std::optional(player.time()) : std::nullopt);
}

} // namespace esm
