#include "app/editor/dialogs/inside_dialog.h"

#include "app/editor/dialogs/box_setup.h"
#include "app/editor/dialogs/inside_texts.h"
#include "app/editor/dialogs/preview_background.h"
#include "app/editor/dialogs/sentence.h"
#include "app/editor/dialogs/wall_format.h"
#include "core/project/detail_change.h"
#include "core/render/organ_scene.h"
#include "core/render/view_state.h"
#include "core/solid/prism_wall.h"
#include "widgets/inputs/control_keys.h"
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
    label->setMinimumHeight(lines * label->fontMetrics().lineSpacing() + 2);
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

NumberFormat layersFormat() {
    NumberFormat format;
    format.decimals = 0;
    format.minimum = 1;
    format.maximum = mostWallLayers;
    format.step = 1;
    return format;
}

} // namespace

InsideDialog::InsideDialog(const Project& project, QWidget* parent)
    : QDialog(parent), m_project(project), m_finder(project.mesh, this), m_view(new OrganView(this)),
      m_kind(new QComboBox(this)), m_spacing(new NumberField(spacingFormat(), this)),
      m_thickness(new NumberField(wallThicknessFormat(), this)),
      m_layers(new NumberField(layersFormat(), this)), m_about(wrapped("insideAbout", 3, this)),
      m_cost(wrapped("insideCounts", 4, this)), m_firmness(wrapped("insideFirmness", 4, this)),
      m_refusal(wrapped("insideRefusal", 6, this)) {
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
    showNow(detailOf(*project.network));
    connect(m_kind, qOverload<int>(&QComboBox::currentIndexChanged), this, &InsideDialog::chooseKind);
    for (NumberField* field : {m_spacing, m_thickness})
        connect(field, &NumberField::valueEdited, this, &InsideDialog::lookAgain);
    connect(m_layers, &NumberField::valueEdited, this, [this] {
        m_hasOwnLayers = true;
        lookAgain();
    });
    showScene(project.network);
    chooseKind();
    resize(1000, 720);
}

void InsideDialog::showNow(const Detail& now) {
    // Of an open surface no lattice can be made.
    const LatticeKind usual =
        m_project.importReport->isClosed() ? LatticeKind::BodyCentred : LatticeKind::Prisms;
    const LatticeFilling filling = now.filling.value_or(LatticeFilling{usual});
    m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(filling.kind)));
    m_thickness->setValue(m_project.base.wallThickness);
    if (!now.filling) return;
    if (!isWall(filling)) return m_spacing->setValue(filling.spacing);
    m_thickness->setValue(filling.wallThickness);
    m_layers->setValue(filling.layers);
    m_hasOwnLayers = filling.layers != usualLayers(*m_project.mesh, filling.wallThickness);
}

void InsideDialog::addQuestions(QVBoxLayout* column) {
    m_kind->setObjectName(QStringLiteral("insideKind"));
    m_kind->addItem(tr("hollow"), -1);
    for (const auto& [kind, name] :
         {std::pair{LatticeKind::BodyCentred, tr("solid, body-centred lattice")},
          std::pair{LatticeKind::Graded, tr("solid, body-centred, coarser within")},
          std::pair{LatticeKind::Cubic, tr("solid, cubic lattice")},
          std::pair{LatticeKind::Diamond, tr("solid, diamond lattice")},
          std::pair{LatticeKind::BareDiamond, tr("solid, bare diamond lattice")},
          std::pair{LatticeKind::Prisms, tr("hollow, with a wall of prisms")}})
        m_kind->addItem(name, static_cast<int>(kind));
    guardFromWheel(*m_kind);
    m_kind->setToolTip(tr("Whether nodes and springs fill the organ, and how they are laid out"));
    m_spacing->setObjectName(QStringLiteral("insideSpacing"));
    m_thickness->setObjectName(QStringLiteral("insideThickness"));
    m_layers->setObjectName(QStringLiteral("insideLayers"));
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
        field->setAccessibleName(withoutMnemonic(caption));
        form->addRow(label, field);
    };
    addField(tr("&Inside"), m_kind);
    form->addRow(m_about);
    addField(tr("&Spacing"), m_spacing);
    addField(tr("Wall &thickness"), m_thickness);
    addField(tr("&Layers"), m_layers);
    for (QLabel* label : {m_cost, m_firmness, m_refusal})
        form->addRow(label);
    column->addLayout(form);
    column->addStretch();
    // A long refusal would push the picture aside.
    for (QLabel* label : {m_about, m_cost, m_firmness, m_refusal})
        label->setFixedWidth(320);
}

void InsideDialog::addButtons(QVBoxLayout* column) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_accept = new QPushButton(tr("&Fill"), this);
    m_accept->setObjectName(QStringLiteral("insideAccept"));
    m_accept->setProperty("primary", true);
    m_accept->setDefault(true);
    buttons->addButton(m_accept, QDialogButtonBox::AcceptRole);
    QPushButton* cancel = buttons->button(QDialogButtonBox::Cancel);
    cancel->setToolTip(tr("Keep the organ as it is"));
    // While the inside is made the tab key reaches it past the other button, and Enter would throw that away.
    cancel->setAutoDefault(false);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

std::optional<LatticeKind> InsideDialog::kind() const {
    const int kind = m_kind->currentData().toInt();
    return kind < 0 ? std::nullopt : std::optional(static_cast<LatticeKind>(kind));
}

/// Of 0 where that is to be the usual. Precondition: the organ is not to be hollow.
LatticeFilling InsideDialog::filling() const {
    if (kind() != LatticeKind::Prisms) return {*kind(), m_spacing->value().value_or(0)};
    return {LatticeKind::Prisms, 0, m_thickness->value().value_or(0),
            static_cast<int>(m_layers->value().value_or(0))};
}

Detail InsideDialog::detail() const {
    if (!kind()) return hollowDetail(m_project);
    return {Detail::Kind::Filled, 0, filling()};
}

std::shared_ptr<const SpringNetwork> InsideDialog::network() const {
    const std::shared_ptr<const SpringNetwork> shown = m_view->scene().network;
    if (!kind()) return nullptr;
    return detailOf(*shown).filling == detail().filling ? shown : nullptr;
}

void InsideDialog::chooseKind() {
    m_about->setText(aboutInside(kind()));
    enableNumbers();
    m_accept->setText(!kind()                         ? tr("Make &hollow")
                      : kind() == LatticeKind::Prisms ? tr("Make &wall")
                                                      : tr("&Fill"));
    if (!kind()) return showHollow();
    lookAgain();
}

void InsideDialog::enableNumbers() {
    const bool hasWall = kind() == LatticeKind::Prisms;
    enable(m_spacing, kind() && !hasWall,
           tr("Distance between neighbouring nodes: half as much is eight times as many nodes"),
           hasWall ? tr("The nodes of a wall lie at the vertices and beneath them")
                   : tr("A hollow organ has no nodes inside"));
    enable(m_thickness, hasWall, tr("How far the wall reaches inwards from the surface"),
           tr("Only a wall of prisms has a thickness"));
    enable(m_layers, hasWall,
           tr("How many prisms lie one beneath the other: with two or more the wall bends as tissue does, "
              "with one three times as stiffly"),
           tr("Only a wall of prisms has layers"));
}

void InsideDialog::lookAgain() {
    if (m_isAnswered || !kind()) return;
    m_refusal->clear();
    esm::enable(m_accept, false, {}, tr("The inside is being made"));
    m_view->setHint(tr("The inside is being made …"));
    LatticeFilling asked = filling();
    if (isWall(asked) && !m_hasOwnLayers) asked.layers = 0;
    m_finder.look(asked);
}

void InsideDialog::takeAnswer() {
    if (m_isAnswered || !kind()) return;       // it was told before, and the finder may be no more
    const bool isDone = !m_finder.isWorking(); // asked first, so that what is done is the last there is
    const auto outcome = m_finder.outcome();
    if (isDone && !outcome.failure.empty()) {
        m_refusal->setText(sentence(outcome.failure));
        m_cost->clear();
        m_firmness->clear();
        m_view->setHint(tr("Shown is what there was before"));
        esm::enable(m_accept, false, {}, m_refusal->text());
        return;
    }
    if (outcome.answer && outcome.answer->filling.kind == *kind()) showFound(*outcome.answer, isDone);
}

void InsideDialog::showFound(const FoundInside& found, bool isDone) {
    if (!isWall(found.filling) && !m_spacing->value()) m_spacing->setValue(found.filling.spacing);
    if (isWall(found.filling) && !m_hasOwnLayers) m_layers->setValue(found.filling.layers);
    // Rigid tissue is told by other numbers, which a filled organ does not keep.
    if (detailOf(*m_project.network).kind != Detail::Kind::Rigid)
        m_firmness->setText(insideFirmness(m_project, found.filling.kind));
    m_refusal->setText(insideNotice(found, m_project.mesh->triangles.size()));
    m_cost->setText(insideCost(found, m_project.mesh->vertices.size()));
    if (!isDone) return m_view->setHint(tr("The inside is being made … %1 %").arg(qRound(100 * found.share)));
    if (!found.network) {
        esm::enable(m_accept, true, tr("Take it; so many nodes are not shown before"), {});
        return m_view->setHint(tr("So many nodes are not shown before they are taken"));
    }
    esm::enable(m_accept, true, tr("Take it as it is shown"), {});
    showScene(found.network);
}

void InsideDialog::showHollow() {
    m_refusal->clear();
    m_firmness->clear();
    m_cost->setText(tr("%1 nodes").arg(countText(m_project.mesh->vertices.size())));
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
