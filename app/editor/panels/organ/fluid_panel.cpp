#include "app/editor/panels/organ/fluid_panel.h"

#include "app/editor/dialogs/sentence.h"
#include "core/model/scene_cavities.h"
#include "core/support/pressure_units.h"
#include "widgets/fuzzy/small_font.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quantity_formats.h"

#include <QSignalBlocker>

#include <algorithm>
#include <numeric>

namespace esm {

namespace {

constexpr double speck = 1e-6;         ///< of the largest part's volume; what surfaces bring along is smaller
constexpr std::size_t mostListed = 30; ///< parts, beside those that hold something
constexpr qint64 betweenReadings = 100;   ///< ms; numbers that change faster cannot be read
constexpr std::size_t mostOpenNamed = 10; ///< parts, in a tool tip

/// Up to several times that of water, 2.2 GPa.
NumberFormat fluidStiffnessFormat() {
    NumberFormat format = modulusFormat();
    format.minimum = 1;
    format.maximum = 1e10;
    return format;
}

/// From a vacuum up to what bursts any vessel.
NumberFormat pressureFormat() {
    NumberFormat format;
    format.unit = QStringLiteral("mmHg");
    format.shownPerValue = 1 / pascalPerMillimetreOfMercury;
    format.minimum = -750 * pascalPerMillimetreOfMercury;
    format.maximum = 7500 * pascalPerMillimetreOfMercury;
    format.step = pascalPerMillimetreOfMercury;
    return format;
}

QString volumeText(double cubicMetres) {
    const double millilitres = 1e6 * cubicMetres;
    if (millilitres < 0.01) return QObject::tr("%1 µL").arg(numberText(1e3 * millilitres, 3));
    if (millilitres >= 1e4) return QObject::tr("%1 L").arg(numberText(1e-3 * millilitres));
    return QObject::tr("%1 mL").arg(numberText(millilitres));
}

QString kilopascalText(double pascal) {
    return QObject::tr("%1 kPa").arg(decimalText(1e-3 * pascal, 3));
}

QString pressureText(double pascal) {
    return QObject::tr("%1 · %2 mmHg")
        .arg(kilopascalText(pascal), decimalText(pascal / pascalPerMillimetreOfMercury, 1));
}

bool holdsFluid(const Scene& scene, std::uint32_t part) {
    return fluidOf(scene, part) || pressureOf(scene, part);
}

/// "Part 2", which files number 1: people count from 1.
QString nameOf(const FillablePart& part) {
    return QObject::tr("Part %1").arg(part.part + 1);
}

/// All that a scene says of fluids, and nothing else, which may be large.
Scene fluidsOf(const Scene& scene) {
    Scene fluids;
    fluids.fillings = scene.fillings;
    fluids.pressures = scene.pressures;
    return fluids;
}

/// The only part whose fluid or pressure is another in two scenes.
std::optional<std::uint32_t> changedPart(const Scene& before, const Scene& after) {
    std::optional<std::uint32_t> only;
    std::vector<std::uint32_t> parts = fluidParts(before);
    for (const std::uint32_t part : fluidParts(after))
        if (!holdsFluid(before, part)) parts.push_back(part);
    const auto isSame = [](const auto* a, const auto* b) { return a && b ? *a == *b : a == b; };
    for (const std::uint32_t part : parts) {
        if (isSame(fluidOf(before, part), fluidOf(after, part)) &&
            isSame(pressureOf(before, part), pressureOf(after, part)))
            continue;
        if (only) return std::nullopt;
        only = part;
    }
    return only;
}

/// Those that can be filled first, the largest before others; returns how many they are.
std::size_t sortForList(std::vector<FillablePart>& parts) {
    std::stable_sort(parts.begin(), parts.end(), [](const FillablePart& a, const FillablePart& b) {
        return a.problem.empty() != b.problem.empty() ? a.problem.empty() : a.volume > b.volume;
    });
    const auto isOpen = [](const FillablePart& part) { return !part.problem.empty(); };
    return static_cast<std::size_t>(std::find_if(parts.begin(), parts.end(), isOpen) - parts.begin());
}

QWidget* beside(QWidget* left, NumberField* field) {
    auto* both = new QWidget;
    auto* row = new QHBoxLayout(both);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(left, 1);
    row->addWidget(field);
    return both;
}

/// "Part 2 · 84.00 mL · filled".
QString nameInList(const FillablePart& part, const Scene& scene) {
    const QString name = QObject::tr("%1 · %2").arg(nameOf(part), volumeText(part.volume));
    if (fluidOf(scene, part.part)) return QObject::tr("%1 · filled").arg(name);
    return pressureOf(scene, part.part) ? QObject::tr("%1 · under pressure").arg(name) : name;
}

} // namespace

FluidPanel::FluidPanel(Document& document, Preview& preview, QWidget* parent)
    : Section(tr("Fluid"), parent), m_document(document), m_preview(preview), m_part(new QComboBox(this)),
      m_filled(new QCheckBox(tr("Filled with fluid of"), this)),
      m_stiffness(new NumberField(fluidStiffnessFormat(), this)),
      m_pressure(new NumberField(pressureFormat(), this)), m_besidePressure(new QStackedWidget(this)),
      m_inKilopascal(new QLabel(this)), m_replace(new QPushButton(tr("One value"), this)),
      m_aside(new ElidedLabel(this)) {
    m_part->setObjectName(QStringLiteral("fluidPart"));
    m_filled->setObjectName(QStringLiteral("fluidFilled"));
    m_stiffness->setObjectName(QStringLiteral("fluidStiffness"));
    m_stiffness->setAccessibleName(tr("Stiffness of the fluid"));
    m_pressure->setObjectName(QStringLiteral("fluidPressure"));
    m_replace->setObjectName(QStringLiteral("fluidReplacePath"));
    m_aside->setObjectName(QStringLiteral("fluidAside"));
    m_part->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_part->setMinimumContentsLength(12);
    guardFromWheel(*m_part);
    // As wide as the fields of tissue above.
    for (NumberField* field : {m_stiffness, m_pressure})
        field->setFixedWidth(m_stiffness->widthFor(QStringLiteral("N·s/m")));
    m_fluids = fluidsOf(document.project().scene);
    addRows();
    connectFields();
    findParts();
    show();
}

void FluidPanel::addRows() {
    auto* of = new ValueRows(this);
    of->addField(tr("Part"), m_part);
    body()->addWidget(of);
    m_aside->setProperty("quiet", true);
    m_aside->setFont(smallFont(m_aside->font()));
    body()->addWidget(m_aside);
    body()->addWidget(beside(m_filled, m_stiffness));
    auto* rows = new ValueRows(this);
    rows->addField(tr("Pressure"), pressureRow());
    m_volumeNow = rows->addText(tr("Volume now"), QStringLiteral("fluidVolumeNow"));
    m_pressureNow = rows->addText(tr("Pressure now"), QStringLiteral("fluidPressureNow"));
    m_volumeNow->setToolTip(
        tr("What the part encloses while the organ moves, and how much that is of its volume at rest"));
    m_pressureNow->setToolTip(
        tr("What presses from within while the organ moves: the fluid's own pressure and the one above"));
    body()->addWidget(rows);
}

QWidget* FluidPanel::pressureRow() {
    m_pressure->setAccessibleName(tr("Pressure from within"));
    m_inKilopascal->setObjectName(QStringLiteral("fluidInKilopascal"));
    m_inKilopascal->setProperty("quiet", true);
    m_inKilopascal->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_inKilopascal->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_besidePressure->addWidget(m_inKilopascal);
    m_besidePressure->addWidget(m_replace);
    QWidget* both = beside(m_besidePressure, m_pressure);
    both->setFocusProxy(m_pressure);
    return both;
}

void FluidPanel::connectFields() {
    connect(m_part, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &FluidPanel::show);
    connect(m_filled, &QCheckBox::clicked, this, &FluidPanel::fill);
    connect(m_stiffness, &NumberField::valueEdited, this, [this](double stiffness) {
        if (!part()) return;
        m_document.edit(
            tr("Set stiffness of the fluid"),
            [stiffness, number = part()->part](Project& project) { fillPart(project, number, stiffness); },
            MergeKey(EditKind::FluidStiffness, part()->part));
    });
    connect(m_pressure, &NumberField::valueEdited, this, [this](double pressure) {
        if (!part()) return;
        m_document.edit(
            tr("Set pressure from within"),
            [pressure, number = part()->part](Project& project) { pressPart(project, number, pressure); },
            MergeKey(EditKind::FluidPressure, part()->part));
    });
    for (const NumberField* field : {m_stiffness, m_pressure})
        connect(field, &NumberField::gestureFinished, &m_document, &Document::finishGesture);
    connect(m_replace, &QPushButton::clicked, this, &FluidPanel::replacePath);
    connect(&m_finder, &PartFinder::found, this, &FluidPanel::listParts);
    connect(&m_document, &Document::changed, this, [this](const Change& change) {
        if (change.mesh) findParts();
        if (change.mesh || change.tissue || change.scene) listParts();
        if (change.scene && !change.mesh) showChangedPart();
        m_fluids = fluidsOf(m_document.project().scene);
    });
    connect(&m_preview, &Preview::tissueReady, this, &FluidPanel::show);
    connect(&m_preview, &Preview::statusChanged, this, &FluidPanel::showNow);
    connect(&m_preview, &Preview::frameReady, this, &FluidPanel::showNowAgain);
}

void FluidPanel::findParts() {
    const Project& project = m_document.project();
    if (!whyNoFluid(project).empty()) return;
    const PartFinder::Surface surface{project.mesh, project.network};
    if (surface == m_surface) return;
    m_surface = surface;
    m_finder.find(surface);
}

void FluidPanel::listParts() {
    const Scene& scene = m_document.project().scene;
    const bool isRoom = whyNoFluid(m_document.project()).empty();
    m_parts = isRoom ? m_finder.parts() : std::vector<FillablePart>();
    m_closed = sortForList(m_parts);
    const QVariant before = m_part->currentData();
    const QSignalBlocker quiet(m_part);
    m_part->clear();
    for (std::size_t i = 0; i < m_closed; ++i) {
        const FillablePart& part = m_parts[i];
        const bool isMinor = i >= mostListed || part.volume < speck * m_parts.front().volume;
        if (isMinor && !holdsFluid(scene, part.part)) continue;
        m_part->addItem(nameInList(part, scene), part.part);
    }
    if (m_part->count() == 0)
        m_part->addItem(m_parts.empty() ? QString(QChar(0x2013)) : tr("no part is closed"));
    m_part->setCurrentIndex(std::max(0, m_part->findData(before)));
    show();
}

/// What is undone or done again is seen, also of a part that is not shown.
void FluidPanel::showChangedPart() {
    const std::optional<std::uint32_t> changed = changedPart(m_fluids, m_document.project().scene);
    if (const int row = changed ? m_part->findData(*changed) : -1; row >= 0) m_part->setCurrentIndex(row);
}

const FillablePart* FluidPanel::part() const {
    const QVariant shown = m_part->currentData();
    if (!shown.isValid()) return nullptr;
    const auto isShown = [&](const FillablePart& part) { return part.part == shown.toUInt(); };
    const auto found = std::find_if(m_parts.begin(), m_parts.end(), isShown);
    return found == m_parts.end() ? nullptr : &*found;
}

QString FluidPanel::refusal() const {
    const Project& project = m_document.project();
    if (const std::string why = whyNoFluid(project); !why.empty())
        return project.network->lattice ? tr("%1. Model → Inside… makes it hollow").arg(sentence(why))
                                        : sentence(why);
    if (m_finder.isWorking()) return tr("The parts of the surface are being looked at");
    const FillablePart* shown = part();
    if (!shown)
        return m_parts.empty() ? tr("The surface has no part")
                               : nameOf(m_parts.front()) + QString::fromStdString(m_parts.front().problem);
    if (!holdsFluid(project.scene, shown->part) && fluidParts(project.scene).size() >= mostFluids)
        return tr("No more than %1 parts can hold a fluid: take it out of another one first").arg(mostFluids);
    return {};
}

double FluidPanel::proposedStiffness(const FillablePart& part) const {
    const std::shared_ptr<const TissueModel> tissue = m_preview.tissue();
    if (!tissue || tissue->springConstant.empty())
        return usualFluidStiffness(m_document.project().base.springConstant, part.volume);
    const std::vector<double>& constants = tissue->springConstant;
    const double mean =
        std::accumulate(constants.begin(), constants.end(), 0.0) / static_cast<double>(constants.size());
    return usualFluidStiffness(mean, part.volume);
}

void FluidPanel::show() {
    const Scene& scene = m_document.project().scene;
    const FillablePart* shown = part();
    const QString why = refusal();
    const FluidFilling* fluid = shown ? fluidOf(scene, shown->part) : nullptr;
    enable(m_part, shown,
           shown ? tr("Connected parts of the surface that are closed, the largest first. Scene files and "
                      "reports count from 0: there this one is part %1")
                       .arg(shown->part)
                 : QString(),
           why);
    enable(
        m_filled, why.isEmpty(),
        tr("The part keeps to its volume, as a bladder, a ventricle or a cyst does: pushed in at one place, "
           "its wall goes out at others. The fluid weighs nothing and does not flow"),
        why);
    m_filled->setChecked(fluid);
    enable(m_stiffness, fluid,
           tr("The pressure in the part rises by a hundredth of this for each percent by which it is pressed "
              "together. Proposed is what keeps the volume within about 0.1 %, whatever the wall can bear"),
           why.isEmpty() ? tr("Fill the part first") : why);
    m_stiffness->setValue(fluid   ? std::optional(fluid->stiffness)
                          : shown ? std::optional(proposedStiffness(*shown))
                                  : std::nullopt);
    showPressure(shown ? pressureOf(scene, shown->part) : nullptr, why);
    showAside();
    showNow();
}

void FluidPanel::showPressure(const PartPressure* pressure, const QString& refusal) {
    const bool hasPath = pressure && !isConstant(*pressure);
    const std::optional<double> pascal = !refusal.isEmpty() || hasPath ? std::nullopt
                                         : pressure ? std::optional(pressure->path.front().pressure)
                                                    : std::optional(0.0);
    m_pressure->setEmptyText(hasPath ? tr("from file, %1 rows").arg(pressure->path.size())
                                     : QString(QChar(0x2013)));
    m_pressure->setValue(pascal);
    enable(
        m_pressure, refusal.isEmpty() && !hasPath,
        tr("Presses from within on the wall for as long as the organ moves, in Play scene as well: blood's, "
           "a balloon's. 0 is none; kPa can be typed too. In a part that is filled, a stiff fluid takes "
           "nearly all of it on itself: fill none through which blood flows"),
        hasPath ? tr("The pressure follows a path from a scene file, which Play scene plays; the organ that "
                     "you pull does not feel it")
                : refusal);
    m_inKilopascal->setText(pascal && *pascal != 0 ? tr("%1 =").arg(kilopascalText(*pascal)) : QString());
    m_besidePressure->setCurrentWidget(hasPath ? static_cast<QWidget*>(m_replace) : m_inKilopascal);
    if (hasPath)
        m_replace->setToolTip(
            tr("Let one pressure act in place of the path from the scene file: its last, %1")
                .arg(pressureText(pressure->path.back().pressure)));
}

/// What is not listed, and why.
void FluidPanel::showAside() {
    const std::size_t open = m_parts.size() - m_closed;
    const std::size_t left = m_closed - std::min(m_closed, static_cast<std::size_t>(m_part->count()));
    QStringList said, reasons;
    if (open > 0)
        said << (open == 1 ? tr("1 open part holds no fluid") : tr("%1 open parts hold no fluid").arg(open));
    if (left > 0)
        said << (left == 1 ? tr("1 small one is not listed") : tr("%1 small ones are not listed").arg(left));
    for (std::size_t i = m_closed; i < std::min(m_parts.size(), m_closed + mostOpenNamed); ++i)
        reasons << nameOf(m_parts[i]) + QString::fromStdString(m_parts[i].problem);
    if (open > mostOpenNamed) reasons << tr("… and %1 more").arg(open - mostOpenNamed);
    m_aside->setText(said.join(QStringLiteral(" · ")));
    m_aside->setToolTip(reasons.join('\n'));
    m_aside->setVisible(!said.isEmpty());
}

void FluidPanel::showNowAgain() {
    if (!m_shownNow.isValid() || m_shownNow.elapsed() >= betweenReadings) showNow();
}

void FluidPanel::showNow() {
    m_shownNow.start();
    const PreviewStatus status = m_preview.status();
    const FillablePart* shown = part();
    const auto isShown = [&](const PartNow& now) { return shown && now.part == shown->part; };
    const auto now = std::find_if(status.fluids.begin(), status.fluids.end(), isShown);
    const bool isKnown = status.playing && now != status.fluids.end();
    const QString none(QChar(0x2013));
    m_volumeNow->setText(
        isKnown ? tr("%1 · %2 %").arg(volumeText(now->volume), decimalText(100 * now->share, 2)) : none);
    m_pressureNow->setText(isKnown ? pressureText(now->pressure) : none);
}

void FluidPanel::fill(bool on) {
    const FillablePart* shown = part();
    if (!shown) return;
    const std::optional<double> stiffness = on ? std::optional(proposedStiffness(*shown)) : std::nullopt;
    m_document.edit(
        on ? tr("Fill part with fluid") : tr("Take fluid out"),
        [stiffness, number = shown->part](Project& project) { fillPart(project, number, stiffness); });
}

void FluidPanel::replacePath() {
    const FillablePart* shown = part();
    const PartPressure* pressure = shown ? pressureOf(m_document.project().scene, shown->part) : nullptr;
    if (!pressure) return;
    const double last = pressure->path.back().pressure;
    m_document.edit(tr("Replace pressure path by one value"),
                    [last, number = shown->part](Project& project) { pressPart(project, number, last); });
}

} // namespace esm
