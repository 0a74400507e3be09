#include "app/editor/panels/measure/virtual_test_panel.h"

#include "app/editor/dialogs/sentence.h"
#include "app/editor/edits/preset_in_force.h"
#include "app/editor/panels/measure/test_figures.h"
#include "core/probing/standing_finger.h"
#include "core/support/angles.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quantity_formats.h"
#include "widgets/inputs/refused_numbers.h"

#include <QVariant>
#include <QVBoxLayout>

#include <algorithm>

namespace esm {

namespace {

constexpr int linesOfPurpose = 2;

NumberFormat fingerFormat() {
    NumberFormat format = lengthFormat(smallestLength);
    format.decimals = -1; // small organs are pressed by tenths of a millimetre
    format.step = 0.0005;
    return format;
}

/// Longer than the finger takes to its depth.
NumberFormat durationFormat() {
    NumberFormat format = timeFormat();
    format.minimum = 0.1;
    format.maximum = 1e4;
    return format;
}

/// What one kind of test is called and does.
struct KindText {
    QString name, said, button;
};

KindText textOf(TestKind kind) {
    switch (kind) {
    case TestKind::Press:
        return {VirtualTestPanel::tr("Press"),
                VirtualTestPanel::tr("Presses the organ at rest, and says how it resists."),
                VirtualTestPanel::tr("Press")};
    case TestKind::Stay:
        return {
            VirtualTestPanel::tr("Press and stay"),
            VirtualTestPanel::tr("Presses to a depth, stays there, and says how the force falls in time."),
            VirtualTestPanel::tr("Press and stay")};
    case TestKind::Strip:
        return {VirtualTestPanel::tr("Pull a strip"),
                VirtualTestPanel::tr(
                    "Cuts a strip out of the organ, pulls at its ends, and says how it resists."),
                VirtualTestPanel::tr("Pull")};
    case TestKind::Push:
        break;
    }
    return {VirtualTestPanel::tr("Push with a force"),
            VirtualTestPanel::tr("Pushes with one force all the time, and says how deep it sinks in."),
            VirtualTestPanel::tr("Push")};
}

NumberFormat turnFormat() {
    NumberFormat format = angleFormat();
    format.minimum = -180;
    format.maximum = 180;
    return format;
}

QString placeText(const std::optional<Eigen::Vector3d>& place) {
    if (!place) return VirtualTestPanel::tr("none yet");
    const auto millimetres = [&](int axis) { return decimalText(1000 * (*place)[axis], 0); };
    return VirtualTestPanel::tr("%1, %2, %3 mm").arg(millimetres(0), millimetres(1), millimetres(2));
}

bool isMostlySlack(const MeasuredStrip& strip) {
    const StripPoint& end = strip.result.curve.back();
    return end.strain < 0.5 * end.elongation / strip.settings.length;
}

/// Rows that keep their height on a page that is higher.
QWidget* standingAtTop(ValueRows* rows) {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(rows);
    column->addStretch();
    return page;
}

} // namespace

VirtualTestPanel::VirtualTestPanel(Document& document, VirtualTest& test, QWidget* parent)
    : QWidget(parent), m_document(document), m_test(test), m_said(new QLabel(this)),
      m_choose(new QPushButton(tr("Choose on the organ"), this)), m_press(new QPushButton(this)),
      m_cancel(new QPushButton(tr("Cancel"), this)), m_kind(new QComboBox(this)),
      m_radius(new NumberField(fingerFormat(), this)), m_depth(new NumberField(fingerFormat(), this)),
      m_force(new NumberField(forceFormat(), this)), m_duration(new NumberField(durationFormat(), this)),
      m_length(new NumberField(fingerFormat(), this)), m_width(new NumberField(fingerFormat(), this)),
      m_stretch(new NumberField(percentFormat(0.001, largestStretch), this)),
      m_turn(new NumberField(turnFormat(), this)), m_sizes(new QStackedWidget(this)),
      m_news(new WorkNews(QStringLiteral("press"), tr("How much of the test is computed"), this)),
      m_figures(new QStackedWidget(this)), m_published(new ElidedLabel(this)) {
    auto* asked = new Section(tr("Test"), this);
    asked->body()->addWidget(buildQuestion());
    asked->body()->addWidget(buildButtons());
    asked->body()->addWidget(m_news);
    auto* met = new Section(tr("What it met"), this);
    for (std::size_t kind = 0; kind < testKinds; ++kind)
        m_figures->addWidget(new PressFigures(testFigures(static_cast<TestKind>(kind)), m_figures));
    met->body()->addWidget(m_figures);
    m_published->setObjectName(QStringLiteral("publishedModulus"));
    m_published->setProperty("quiet", true);
    met->body()->addWidget(m_published);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(asked);
    column->addWidget(met);

    connect(&m_test, &VirtualTest::changed, this, &VirtualTestPanel::refresh);
    refresh();
}

QWidget* VirtualTestPanel::buildQuestion() {
    auto* whole = new QWidget(this);
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    m_said->setProperty("quiet", true);
    m_said->setWordWrap(true);
    m_said->setAlignment(Qt::AlignTop);
    m_said->ensurePolished();
    m_said->setMinimumHeight(linesOfPurpose * m_said->fontMetrics().lineSpacing());
    column->addWidget(m_said);
    auto* rows = new ValueRows(whole);
    m_place = rows->addText(tr("Place"), QStringLiteral("pressPlace"));
    m_place->setToolTip(tr("Where the finger presses, or the middle of the strip, on the organ at rest"));
    m_choose->setObjectName(QStringLiteral("choosePressPlace"));
    column->addWidget(rows);
    column->addWidget(m_choose);
    column->addWidget(buildKind());
    m_sizes->addWidget(standingAtTop(buildFingerRows()));
    m_sizes->addWidget(standingAtTop(buildStripRows()));
    column->addWidget(m_sizes);
    return whole;
}

ValueRows* VirtualTestPanel::buildKind() {
    auto* rows = new ValueRows(this);
    for (std::size_t kind = 0; kind < testKinds; ++kind)
        m_kind->addItem(textOf(static_cast<TestKind>(kind)).name);
    m_kind->setObjectName(QStringLiteral("fingerTest"));
    m_kind->setToolTip(tr("What is done to the organ. What was measured by the others stays"));
    guardFromWheel(*m_kind);
    rows->addField(tr("&Kind"), m_kind);
    connect(m_kind, qOverload<int>(&QComboBox::activated), this,
            [this](int kind) { m_test.chooseKind(static_cast<TestKind>(kind)); });
    return rows;
}

void VirtualTestPanel::connectField(NumberField* field, const char* name, void (VirtualTest::*set)(double)) {
    field->setObjectName(QString::fromLatin1(name));
    connect(field, &NumberField::valueEdited, &m_test, set);
    connect(field, &QLineEdit::returnPressed, this, [this, field] {
        if (field->refusal().isEmpty()) press();
    });
}

ValueRows* VirtualTestPanel::buildFingerRows() {
    m_rows = new ValueRows(this);
    m_rows->addField(tr("Ra&dius"), m_radius);
    m_rows->addEither(tr("De&pth"), m_depth, tr("For&ce"), m_force);
    m_rows->addField(tr("D&uration"), m_duration);
    connectField(m_radius, "fingerRadius", &VirtualTest::setRadius);
    connectField(m_depth, "fingerDepth", &VirtualTest::setDepth);
    connectField(m_force, "fingerForce", &VirtualTest::setForce);
    connectField(m_duration, "fingerDuration", &VirtualTest::setDuration);
    m_radius->setToolTip(tr("Of the finger's round tip"));
    m_depth->setToolTip(tr("How deep it presses, from where it first touches"));
    m_force->setToolTip(tr("With which it is pushed from the first moment on; what the last press met, until "
                           "another is typed"));
    return m_rows;
}

ValueRows* VirtualTestPanel::buildStripRows() {
    auto* rows = new ValueRows(this);
    rows->addField(tr("Len&gth"), m_length);
    rows->addField(tr("W&idth"), m_width);
    rows->addField(tr("Stretch &by"), m_stretch);
    rows->addField(tr("Tur&ned by"), m_turn);
    connectField(m_length, "stripLength", &VirtualTest::setStripLength);
    connectField(m_width, "stripWidth", &VirtualTest::setStripWidth);
    connectField(m_stretch, "stripStretch", &VirtualTest::setStretch);
    connectField(m_turn, "stripTurn", &VirtualTest::setTurn);
    m_length->setToolTip(tr("Between the clamps"));
    m_width->setToolTip(tr("Of the strip; of a solid organ it is cut out as deep"));
    m_stretch->setToolTip(tr("Of its length, how much longer it is made"));
    m_turn->setToolTip(
        tr("From the direction in which the organ is longest, to the left as seen from outside"));
    return rows;
}

QWidget* VirtualTestPanel::buildButtons() {
    auto* whole = new QWidget(this);
    auto* row = new QHBoxLayout(whole);
    row->setContentsMargins(0, 0, 0, 0);
    m_press->setObjectName(QStringLiteral("pressButton"));
    m_press->setAutoDefault(true); // Enter works where it has the keys
    m_cancel->setObjectName(QStringLiteral("cancelPress"));
    row->addWidget(m_press, 2);
    row->addWidget(m_cancel, 1);
    connect(m_press, &QPushButton::clicked, this, &VirtualTestPanel::press);
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        m_press->setFocus(); // else a field would take the keys, since the button cannot be used any more
        m_test.cancel();
    });
    return whole;
}

void VirtualTestPanel::setPlaceAction(QAction* action) {
    follow(m_choose, action);
}

void VirtualTestPanel::press() {
    if (takesAllNumbers(*this)) m_test.press();
}

void VirtualTestPanel::refresh() {
    m_place->setText(placeText(m_test.restPlace()));
    showTest();
    const QString obstacle = m_test.obstacle();
    enable(m_press, obstacle.isEmpty(), tr("Measure how the organ resists (Enter in a field)"), obstacle);
    enable(m_cancel, m_test.isPressing(), tr("Stop measuring; what was measured before stays"),
           tr("Nothing is being measured"));
    auto* figures = static_cast<PressFigures*>(m_figures->currentWidget());
    figures->setResults(m_test.latest().get(), m_test.former().get());
    showPublished();
    showNews();
}

void VirtualTestPanel::showTest() {
    const TestKind kind = m_test.kind();
    const KindText text = textOf(kind);
    m_said->setText(text.said);
    m_press->setText(text.button);
    m_kind->setCurrentIndex(static_cast<int>(kind));
    m_figures->setCurrentIndex(static_cast<int>(kind));
    m_sizes->setCurrentIndex(kind == TestKind::Strip ? 1 : 0);
    m_rows->showField(kind == TestKind::Push ? m_force : m_depth);
    m_length->setValue(m_test.stripSettings().length);
    m_width->setValue(m_test.stripSettings().width);
    m_stretch->setValue(m_test.stripSettings().stretch);
    m_turn->setValue(toDegrees(m_test.stripSettings().turn));
    m_radius->setValue(m_test.settings().radius);
    m_depth->setValue(m_test.settings().depth);
    m_force->setValue(m_test.force());
    m_duration->setValue(m_test.duration());
    enable(m_duration, kind != TestKind::Press,
           kind == TestKind::Stay ? tr("Of the whole test; the finger is at its depth within 0.05 s")
                                  : tr("For how long it is pushed"),
           tr("A press is measured at rest, however long that takes"));
}

/// What to hold the modulus or the relaxation time against, where the tissue at the place is as it was
/// measured of people.
void VirtualTestPanel::showPublished() {
    const auto place = m_test.restPlace();
    const auto preset = place ? presetInForceAt(m_document.project(), *place) : std::nullopt;
    const bool isPress = m_test.kind() == TestKind::Press || m_test.kind() == TestKind::Strip;
    const PublishedTissue published = preset ? preset->published : PublishedTissue();
    const auto value = isPress ? published.youngsModulus : published.relaxationTime;
    const QString number = !value    ? QString()
                           : isPress ? withUnit(*value / 1000, QStringLiteral("kPa"), 3)
                                     : withUnit(*value, QStringLiteral("s"), 3);
    m_published->setText(value ? tr("%1, published: %2").arg(QString::fromStdString(preset->title), number)
                               : QString());
    m_published->setToolTip(value ? QString::fromStdString(preset->source) : QString());
}

void VirtualTestPanel::showNews() {
    const bool isPressing = m_test.isPressing();
    m_news->setProgress(isPressing ? std::optional(m_test.progress()) : std::nullopt);
    QString failure = isPressing ? QString() : sentence(m_test.failure());
    if (!failure.isEmpty() && m_test.latest()) failure += tr("; the numbers below are of the test before");
    m_news->say(failure.isEmpty() ? remark() : failure,
                !failure.isEmpty() || m_test.isOutdated() || isSlack());
}

bool VirtualTestPanel::isSlack() const {
    const VirtualTest::Press& latest = m_test.latest();
    return latest && latest->strip && !latest->strip->result.youngsModulus;
}

/// What else should be known of the numbers, the most needed first.
QString VirtualTestPanel::remark() const {
    const VirtualTest::Press& latest = m_test.latest();
    if (!latest) return m_test.place() ? remarkOnPlace() : m_test.obstacle();
    if (m_test.isOutdated()) return tr("Measured before the last change of the tissue: measure again.");
    if (latest->result.meetsFixed)
        return tr("The finger also lies on fixed nodes, whose force is not counted.");
    if (isSlack())
        return tr("The strip is slack to the end, as one that is bent is until it is straight: stretch it by "
                  "more.");
    if (latest->strip && isMostlySlack(*latest->strip))
        return tr("The strip was slack for most of the way, until it was straight: stretch it by more to "
                  "measure it well.");
    for (const QString& said : {remarkOnTime(), remarkOnFormer(), remarkOnPressure()})
        if (!said.isEmpty()) return said;
    return {};
}

/// Why there is no time constant; empty where there is one, or none is asked for.
QString VirtualTestPanel::remarkOnTime() const {
    const MeasuredPress& latest = *m_test.latest();
    const TimeCurve* curve = latest.inTime();
    if (!curve || curve->timeConstant) return {};
    if (latest.kind == TestKind::Stay && hasNextToNoWay(*curve))
        return tr("There is next to no way that a time constant could be told of: the force falls by less "
                  "than 1 %.");
    return tr("Less than two thirds of the way is gone by then: a longer duration tells the time constant.");
}

/// By what it differs from that which it is compared with, beside the tissue.
QString VirtualTestPanel::remarkOnFormer() const {
    if (!m_test.former()) return remarkOnPlace();
    if (m_test.latest()->strip) return remarkOnFormerStrip();
    const ProbeSettings &now = m_test.latest()->settings, &before = m_test.former()->settings;
    if (before.radius != now.radius)
        return tr("What stands under before was measured with a finger of radius %1.")
            .arg(withUnit(1000 * before.radius, QStringLiteral("mm"), 3));
    if (before.place != now.place) return tr("What stands under before was measured at another place.");
    if (now.creep && before.creep->force != now.creep->force)
        return tr("What stands under before was pushed with %1.")
            .arg(withUnit(before.creep->force, QStringLiteral("N"), 3));
    if (now.relaxation && before.depth != now.depth)
        return tr("What stands under before was pressed %1 deep.")
            .arg(withUnit(1000 * before.depth, QStringLiteral("mm"), 3));
    return remarkOnPlace();
}

QString VirtualTestPanel::remarkOnFormerStrip() const {
    const StripSettings &now = m_test.latest()->strip->settings, &before = m_test.former()->strip->settings;
    if (before.length != now.length || before.width != now.width)
        return tr("What stands under before was measured with a strip of %1 by %2.")
            .arg(withUnit(1000 * before.length, QStringLiteral("mm"), 3),
                 withUnit(1000 * before.width, QStringLiteral("mm"), 3));
    if (before.place != now.place || before.along != now.along)
        return tr("What stands under before was measured at another place, or in another direction.");
    return {};
}

QString VirtualTestPanel::remarkOnPlace() const {
    return m_test.isSeenFromInside() && m_test.kind() != TestKind::Strip
               ? tr("You see the wall's inside here; the finger presses from outside.")
               : QString();
}

/// Of the part that it swells the most; files count from 0.
QString VirtualTestPanel::remarkOnPressure() const {
    const std::vector<InflatedPart>& parts = m_test.latest()->result.inflated;
    const auto share = [](const InflatedPart& part) { return part.volume / part.restVolume; };
    const auto most =
        std::max_element(parts.begin(), parts.end(),
                         [&](const InflatedPart& a, const InflatedPart& b) { return share(a) < share(b); });
    if (most == parts.end()) return {};
    return tr("Under the pressure within, part %1 has %2 % of its volume at rest; depths count from there.")
        .arg(most->part + 1)
        .arg(decimalText(100 * share(*most), 0));
}

} // namespace esm
