#include "app/editor/dialogs/inside_dialog.h"

#include "app/editor/dialogs/box_setup.h"
#include "app/editor/dialogs/preview_background.h"
#include "core/project/detail_change.h"
#include "core/render/organ_scene.h"
#include "core/render/view_state.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/refused_numbers.h"

#include <QDialogButtonBox>
#include <QVBoxLayout>

namespace esm {

namespace {

QLabel* wrapped(const char* name, int lines, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(QLatin1String(name));
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    label->ensurePolished();
    // The room for it is kept, so that nothing moves.
    label->setMinimumHeight(lines * label->fontMetrics().lineSpacing());
    return label;
}

NumberFormat spacingFormat() {
    NumberFormat format;
    format.unit = QStringLiteral("mm");
    format.shownPerValue = 1000;
    format.minimum = 1e-6;
    format.maximum = 1e3;
    return format;
}

/// What a choice means; of none, a hollow organ.
QString aboutText(const std::optional<LatticeKind>& kind) {
    if (!kind)
        return QObject::tr("Springs in the surface alone: a bag, which its tethers and fixed nodes hold in "
                           "form. Every vertex is a node.");
    switch (*kind) {
    case LatticeKind::Cubic:
        return QObject::tr("Cubes with the diagonals of their faces: as firm in every direction.");
    case LatticeKind::BodyCentred:
        return QObject::tr("Cubes with a node in the middle: as firm in every direction, and the fewest "
                           "springs.");
    case LatticeKind::Diamond:
        return QObject::tr("As in diamond, with second neighbours: firmer along some directions than "
                           "others, up to twice.");
    case LatticeKind::Prisms: // which the command line makes
    case LatticeKind::BareDiamond:
        break;
    }
    return QObject::tr("Four neighbours alone: it resists being pressed together, but no shear. The "
                       "surface alone keeps its form.");
}

QString countsText(double nodes, double springs, double tetrahedra) {
    const auto count = [](double number) { return countText(static_cast<std::size_t>(number)); };
    return QObject::tr("%1 nodes, %2 springs, %3 tetrahedra")
        .arg(count(nodes), count(springs), count(tetrahedra));
}

QString firmnessText(const Project& project, LatticeKind kind) {
    const double modulus = youngsModulusOfWall(project.base.springConstant, project.base.wallThickness);
    const QString text =
        kind == LatticeKind::BareDiamond
            ? QObject::tr("%1 N/m of the whole organ then resist being pressed together as tissue of %2 kPa "
                          "does (Young's modulus), however fine the lattice is, and shear not at all.")
            : QObject::tr("%1 N/m of the whole organ are then tissue of %2 kPa (Young's modulus; Poisson's "
                          "ratio is ¼), however fine the lattice is.");
    return text.arg(numberText(project.base.springConstant), numberText(modulus / 1000, 3));
}

/// Where the organ leaves no room for what was asked, and what of its surface is passed over; empty else.
QString noticeText(const FoundInside& found) {
    QStringList notices;
    if (found.estimate.spacing < 0.99 * found.filling.spacing)
        notices += QObject::tr("The organ is too thin for that: neighbours lie about %1 mm apart.")
                       .arg(numberText(1000 * found.estimate.spacing, 2));
    const auto& [places, width] = found.estimate.crossings;
    const QString across = numberText(1000 * width, 2);
    if (places == 1)
        notices +=
            QObject::tr("The surface runs through itself in one place, %1 mm across. The lattice passes "
                        "over it.")
                .arg(across);
    else if (places > 1)
        notices += QObject::tr("The surface runs through itself in %1 places, %2 mm across at most. The "
                               "lattice passes over them.")
                       .arg(countText(places), across);
    return notices.join(QLatin1Char(' '));
}

} // namespace

InsideDialog::InsideDialog(const Project& project, QWidget* parent)
    : QDialog(parent), m_project(project), m_finder(project.mesh, this), m_view(new OrganView(this)),
      m_kind(new QComboBox(this)), m_spacing(new NumberField(spacingFormat(), this)),
      m_about(wrapped("insideAbout", 3, this)), m_counts(wrapped("insideCounts", 3, this)),
      m_firmness(wrapped("insideFirmness", 4, this)), m_refusal(wrapped("insideRefusal", 5, this)) {
    setWindowTitle(tr("Inside of the organ"));
    setObjectName(QStringLiteral("insideDialog"));
    m_view->setAccessibleName(tr("The organ, cut open"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 18);
    column->setSpacing(12);
    auto* row = new QHBoxLayout;
    row->setSpacing(16);
    row->addWidget(m_view, 1);
    auto* questions = new QVBoxLayout;
    addQuestions(questions);
    row->addLayout(questions);
    column->addLayout(row, 1);
    addButtons(column);
    // The picture and other widgets would keep it for themselves.
    rejectOnEscape(*this);
    connect(&m_finder, &InsideFinder::answered, this, &InsideDialog::takeAnswer);
    const Detail now = detailOf(*project.network);
    const bool isLattice = now.filling && !isWall(*now.filling);
    m_kind->setCurrentIndex(m_kind->findData(isLattice ? static_cast<int>(now.filling->kind)
                                                       : static_cast<int>(LatticeKind::BodyCentred)));
    if (isLattice) m_spacing->setValue(now.filling->spacing);
    connect(m_kind, qOverload<int>(&QComboBox::currentIndexChanged), this, &InsideDialog::chooseKind);
    connect(m_spacing, &NumberField::valueEdited, this, &InsideDialog::lookAgain);
    showScene(project.network);
    chooseKind();
    resize(1000, 660);
}

void InsideDialog::addQuestions(QVBoxLayout* column) {
    m_kind->setObjectName(QStringLiteral("insideKind"));
    m_kind->addItem(tr("hollow"), -1);
    for (const auto& [kind, name] : {std::pair{LatticeKind::BodyCentred, tr("solid, body-centred lattice")},
                                     std::pair{LatticeKind::Cubic, tr("solid, cubic lattice")},
                                     std::pair{LatticeKind::Diamond, tr("solid, diamond lattice")},
                                     std::pair{LatticeKind::BareDiamond, tr("solid, bare diamond lattice")}})
        m_kind->addItem(name, static_cast<int>(kind));
    m_kind->setToolTip(tr("Whether nodes and springs fill the organ, and how they are laid out"));
    m_kind->setAccessibleName(tr("Inside"));
    m_spacing->setObjectName(QStringLiteral("insideSpacing"));
    m_spacing->setAccessibleName(tr("Spacing"));
    m_refusal->setProperty("warning", true);
    for (QLabel* label : {m_about, m_firmness})
        label->setProperty("quiet", true);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(8);
    const auto addField = [&](const QString& caption, QWidget* field) {
        auto* label = new QLabel(caption, this);
        label->setProperty("quiet", true);
        label->setBuddy(field);
        form->addRow(label, field);
    };
    addField(tr("&Inside"), m_kind);
    form->addRow(m_about);
    addField(tr("&Spacing"), m_spacing);
    for (QLabel* label : {m_counts, m_firmness, m_refusal})
        form->addRow(label);
    column->addLayout(form);
    column->addStretch();
    // A long refusal would push the picture aside.
    for (QLabel* label : {m_about, m_counts, m_firmness, m_refusal})
        label->setFixedWidth(320);
}

void InsideDialog::addButtons(QVBoxLayout* column) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_accept = new QPushButton(tr("&Fill"), this);
    m_accept->setObjectName(QStringLiteral("insideAccept"));
    m_accept->setProperty("primary", true);
    m_accept->setDefault(true);
    buttons->addButton(m_accept, QDialogButtonBox::AcceptRole);
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Keep the organ as it is"));
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

std::optional<LatticeKind> InsideDialog::kind() const {
    const int kind = m_kind->currentData().toInt();
    return kind < 0 ? std::nullopt : std::optional(static_cast<LatticeKind>(kind));
}

Detail InsideDialog::detail() const {
    if (!kind()) return hollowDetail(m_project);
    return {Detail::Kind::Filled, 0, LatticeFilling{*kind(), m_spacing->value().value_or(0)}};
}

std::shared_ptr<const SpringNetwork> InsideDialog::network() const {
    const std::shared_ptr<const SpringNetwork> shown = m_view->scene().network;
    if (!kind()) return nullptr;
    return detailOf(*shown).filling == detail().filling ? shown : nullptr;
}

void InsideDialog::chooseKind() {
    m_about->setText(aboutText(kind()));
    enable(m_spacing, kind().has_value(),
           tr("Distance between neighbouring nodes: half as much is eight times as many nodes"),
           tr("A hollow organ has no nodes inside"));
    m_accept->setText(kind() ? tr("&Fill") : tr("Make &hollow"));
    if (!kind()) return showHollow();
    lookAgain();
}

void InsideDialog::lookAgain() {
    if (m_isAnswered || !kind()) return;
    m_refusal->clear();
    esm::enable(m_accept, false, {}, tr("The lattice is being made"));
    m_view->setHint(tr("The lattice is being made …"));
    m_finder.look({*kind(), m_spacing->value().value_or(0)});
}

void InsideDialog::takeAnswer() {
    if (m_isAnswered || !kind()) return; // it was told before, and the finder may be no more
    const auto outcome = m_finder.outcome();
    const bool isDone = !m_finder.isWorking();
    if (isDone && !outcome.failure.empty()) {
        m_refusal->setText(QString::fromStdString(outcome.failure));
        m_counts->clear();
        m_firmness->clear();
        m_view->setHint(tr("Shown is what there was before"));
        esm::enable(m_accept, false, {}, m_refusal->text());
        return;
    }
    if (outcome.answer && outcome.answer->filling.kind == *kind()) showFound(*outcome.answer, isDone);
}

void InsideDialog::showFound(const FoundInside& found, bool isDone) {
    if (!m_spacing->value()) m_spacing->setValue(found.filling.spacing);
    // Rigid tissue is told by other numbers, which a filled organ does not keep.
    if (detailOf(*m_project.network).kind != Detail::Kind::Rigid)
        m_firmness->setText(firmnessText(m_project, found.filling.kind));
    m_refusal->setText(noticeText(found));
    const QString memory = tr("%1 MB of memory while it is filled")
                               .arg(numberText(std::max(1.0, found.estimate.bytes / 1e6), 2));
    if (!isDone || !found.network) {
        m_counts->setText(
            tr("About %1; %2")
                .arg(countsText(found.estimate.nodes, found.estimate.springs, found.estimate.tetrahedra),
                     memory));
        esm::enable(m_accept, isDone, tr("Fill the organ; so many nodes are not shown before"),
                    tr("The lattice is being made"));
        if (isDone) m_view->setHint(tr("So many nodes are not shown before they are taken"));
        return;
    }
    const SpringNetwork& network = *found.network;
    m_counts->setText(countsText(static_cast<double>(network.restPositions.size()),
                                 static_cast<double>(network.springs.size()),
                                 static_cast<double>(network.lattice->tetrahedra.size())));
    esm::enable(m_accept, true, tr("Fill the organ as it is shown"), {});
    showScene(found.network);
}

void InsideDialog::showHollow() {
    m_refusal->clear();
    m_firmness->clear();
    m_counts->setText(tr("%1 nodes").arg(countText(m_project.mesh->vertices.size())));
    esm::enable(m_accept, true, tr("Make every vertex a node, with nothing inside"), {});
    showScene(std::make_shared<const SpringNetwork>(networkFromMesh(*m_project.mesh)));
}

/// Cut through the middle, seen from the front, with its springs.
void InsideDialog::showScene(std::shared_ptr<const SpringNetwork> network) {
    const bool isFirst = !m_view->scene().mesh;
    RenderScene scene = organScene(m_project.mesh, std::move(network), m_project.texture.baseColour);
    ViewState state;
    state.springs = true;
    state.cut = Cut{CutSide::Front, 0.5};
    showParts(scene, state, m_view->camera());
    setBackground(scene, *this);
    m_view->setScene(std::move(scene));
    m_view->setHint(tr("Cut through the middle · drag to turn · the wheel comes nearer"));
    if (isFirst) m_view->showView(StandardView::Front);
}

void InsideDialog::accept() {
    // What was typed until now is taken once it is shown.
    if (takesAllNumbers(*this) && m_accept->isEnabled()) QDialog::accept();
}

void InsideDialog::done(int result) {
    m_isAnswered = true;
    QDialog::done(result);
}

} // namespace esm
