#include "app/editor/panels/measure/virtual_test_panel.h"

#include "app/editor/dialogs/sentence.h"
#include "app/editor/edits/preset_in_force.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quantity_formats.h"
#include "widgets/inputs/refused_numbers.h"

#include <QStyle>
#include <QVariant>

namespace esm {

namespace {

constexpr int unsaidTime = 300;    // ms; most tests of small organs are over by then
constexpr int linesOfMessage = 4;  // that the core's sentences need
constexpr int wholeProgress = 100; // of the bar

NumberFormat fingerFormat() {
    NumberFormat format = lengthFormat(smallestLength);
    format.decimals = -1; // small organs are pressed by tenths of a millimetre
    format.step = 0.0005;
    return format;
}

QString placeText(const std::optional<Eigen::Vector3d>& place) {
    if (!place) return VirtualTestPanel::tr("none yet");
    const auto millimetres = [&](int axis) { return decimalText(1000 * (*place)[axis], 0); };
    return VirtualTestPanel::tr("%1, %2, %3 mm").arg(millimetres(0), millimetres(1), millimetres(2));
}

} // namespace

VirtualTestPanel::VirtualTestPanel(Document& document, VirtualTest& test, QWidget* parent)
    : QWidget(parent), m_document(document), m_test(test),
      m_choose(new QPushButton(tr("Choose on the organ"), this)), m_press(new QPushButton(tr("Press"), this)),
      m_cancel(new QPushButton(tr("Cancel"), this)), m_radius(new NumberField(fingerFormat(), this)),
      m_depth(new NumberField(fingerFormat(), this)), m_news(new QStackedWidget(this)),
      m_message(new QLabel(this)), m_progress(new QProgressBar(this)), m_figures(new PressFigures(this)),
      m_published(new ElidedLabel(this)) {
    auto* finger = new Section(tr("Finger"), this);
    finger->body()->addWidget(buildFinger());
    finger->body()->addWidget(buildButtons());
    finger->body()->addWidget(buildNews());
    auto* met = new Section(tr("What it met"), this);
    met->body()->addWidget(m_figures);
    m_published->setObjectName(QStringLiteral("publishedModulus"));
    m_published->setProperty("quiet", true);
    met->body()->addWidget(m_published);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(finger);
    column->addWidget(met);

    m_patience.setSingleShot(true);
    m_patience.setInterval(unsaidTime);
    connect(&m_patience, &QTimer::timeout, this, &VirtualTestPanel::showNews);
    connect(&m_test, &VirtualTest::changed, this, &VirtualTestPanel::refresh);
    refresh();
}

QWidget* VirtualTestPanel::buildFinger() {
    auto* whole = new QWidget(this);
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    auto* said = new QLabel(tr("Presses the organ at rest, and says how it resists."), whole);
    said->setProperty("quiet", true);
    said->setWordWrap(true);
    column->addWidget(said);
    auto* rows = new ValueRows(whole);
    m_place = rows->addText(tr("Place"), QStringLiteral("pressPlace"));
    m_place->setToolTip(tr("Where it presses, on the organ at rest"));
    m_choose->setObjectName(QStringLiteral("choosePressPlace"));
    column->addWidget(rows);
    column->addWidget(m_choose);
    rows = new ValueRows(whole);
    m_radius->setObjectName(QStringLiteral("fingerRadius"));
    m_radius->setToolTip(tr("Of the finger's round tip"));
    rows->addField(tr("Ra&dius"), m_radius);
    m_depth->setObjectName(QStringLiteral("fingerDepth"));
    m_depth->setToolTip(tr("How deep it presses, from where it first touches"));
    rows->addField(tr("De&pth"), m_depth);
    column->addWidget(rows);
    connect(m_radius, &NumberField::valueEdited, &m_test, &VirtualTest::setRadius);
    connect(m_depth, &NumberField::valueEdited, &m_test, &VirtualTest::setDepth);
    for (NumberField* field : {m_radius, m_depth})
        connect(field, &QLineEdit::returnPressed, this, [this, field] {
            if (field->refusal().isEmpty()) press();
        });
    return whole;
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

/// As high as a long sentence, so that what stands below stays where it is.
QWidget* VirtualTestPanel::buildNews() {
    m_message->setObjectName(QStringLiteral("pressMessage"));
    m_message->setWordWrap(true);
    m_message->setAlignment(Qt::AlignTop);
    m_message->ensurePolished();
    m_message->setMinimumHeight(linesOfMessage * m_message->fontMetrics().lineSpacing());
    m_progress->setObjectName(QStringLiteral("pressProgress"));
    m_progress->setAccessibleName(tr("How much of the test is computed"));
    m_progress->setMaximum(wholeProgress);
    auto* barOnTop = new QWidget(m_news);
    auto* column = new QVBoxLayout(barOnTop);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_progress);
    column->addStretch();
    m_news->addWidget(m_message);
    m_news->addWidget(barOnTop);
    return m_news;
}

void VirtualTestPanel::setPlaceAction(QAction* action) {
    follow(m_choose, action);
}

void VirtualTestPanel::press() {
    if (!takesAllNumbers(*this) || !m_test.obstacle().isEmpty()) return;
    m_patience.start();
    m_test.press();
}

void VirtualTestPanel::refresh() {
    m_place->setText(placeText(m_test.restPlace()));
    m_radius->setValue(m_test.settings().radius);
    m_depth->setValue(m_test.settings().depth);
    const QString obstacle = m_test.obstacle();
    enable(m_press, obstacle.isEmpty(), tr("Measure how the organ resists the finger (Enter in a field)"),
           obstacle);
    enable(m_cancel, m_test.isPressing(), tr("Stop measuring; what was measured before stays"),
           tr("Nothing is being measured"));
    const auto resultOf = [](const VirtualTest::Press& press) { return press ? &press->result : nullptr; };
    m_figures->setResults(resultOf(m_test.latest()), resultOf(m_test.former()));
    showPublished();
    showNews();
}

/// What to hold the modulus against, where the tissue at the place is as it was measured of people.
void VirtualTestPanel::showPublished() {
    const auto place = m_test.restPlace();
    const auto preset = place ? presetInForceAt(m_document.project(), *place) : std::nullopt;
    const auto modulus = preset ? preset->published.youngsModulus : std::nullopt;
    m_published->setText(modulus ? tr("%1, published: %2")
                                       .arg(QString::fromStdString(preset->title),
                                            withUnit(*modulus / 1000, QStringLiteral("kPa"), 3))
                                 : QString());
    m_published->setToolTip(modulus ? QString::fromStdString(preset->source) : QString());
}

void VirtualTestPanel::showNews() {
    const bool isLong = m_test.isPressing() && !m_patience.isActive();
    m_progress->setValue(static_cast<int>(m_test.progress() * wholeProgress));
    m_news->setCurrentIndex(isLong ? 1 : 0);
    const QString failure = m_test.isPressing() ? QString() : sentence(m_test.failure());
    const QString said = failure.isEmpty() ? remark() : failure;
    if (said == m_message->text()) return;
    m_message->setText(said);
    m_message->setProperty("warning", !failure.isEmpty() || m_test.isOutdated());
    m_message->setProperty("quiet", failure.isEmpty() && !m_test.isOutdated());
    m_message->style()->unpolish(m_message);
    m_message->style()->polish(m_message);
}

/// What else should be known of the numbers, the most needed first.
QString VirtualTestPanel::remark() const {
    const VirtualTest::Press &latest = m_test.latest(), &former = m_test.former();
    if (!latest) return m_test.place() ? QString() : m_test.obstacle();
    if (m_test.isOutdated()) return tr("Measured before the last change of the tissue: press again.");
    if (latest->result.meetsFixed)
        return tr("The finger also lies on fixed nodes, whose force is not counted.");
    if (!former) return {};
    if (former->settings.radius != latest->settings.radius)
        return tr("What stands under before was measured with a finger of radius %1.")
            .arg(withUnit(1000 * former->settings.radius, QStringLiteral("mm"), 3));
    if (former->settings.place != latest->settings.place)
        return tr("What stands under before was measured at another place.");
    return {};
}

} // namespace esm
