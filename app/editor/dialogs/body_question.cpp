#include "app/editor/dialogs/body_question.h"

#include "app/editor/dialogs/body_work.h"
#include "app/editor/dialogs/wall_format.h"
#include "core/geometry/simplified_mesh.h"
#include "core/model/motion_model.h"
#include "core/project/wall.h"
#include "core/solid/filled_body.h"
#include "core/solid/prism_wall.h"
#include "widgets/inputs/action_texts.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quiet_label.h"

#include <QHBoxLayout>
#include <QRadioButton>

#include <algorithm>

namespace esm {

namespace {

/// A fifth of what moved several times as fast as real time on two processors (docs/performance.md).
constexpr std::size_t suggestedNodes = 2000;
/// A lattice of fewer shows no form, of more takes minutes to fill and to play.
constexpr double fewestSolidNodes = 100, mostSolidNodes = 1e5;
NumberFormat countFormat(double fewest, double most) {
    NumberFormat format;
    format.decimals = 0;
    format.minimum = fewest;
    format.maximum = std::max(fewest, most);
    return format;
}

void addRow(QFormLayout* form, QWidget* left, QLabel* right) {
    right->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* row = new QHBoxLayout;
    row->addWidget(left, 1);
    row->addWidget(right);
    form->addRow(row);
}

} // namespace

BodyQuestion::BodyQuestion(QWidget* parent)
    : QWidget(parent), m_bodies(new QButtonGroup(this)), m_work{}, m_detail(new QComboBox(this)),
      m_nodes(new NumberField(countFormat(fewestVertices, fewestVertices), this)),
      m_thickness(new NumberField(wallThicknessFormat(), this)), m_suggestion(quietLabel({}, this)),
      m_fewerNodes(static_cast<double>(suggestedNodes)), m_solidNodes(usualLatticeNodes) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(8);
    addBodies(form);
    addDetail(form);
}

void BodyQuestion::addBodies(QFormLayout* form) {
    addRow(form, quietLabel(tr("The organ is …"), this), quietLabel(tr("work of a step"), this));
    const std::array<QString, 4> names{tr("&hollow, and bends freely"),
                                       tr("hollow, with a &wall that resists bending"),
                                       tr("hollow, with a wall of &prisms"), tr("&solid, filled with nodes")};
    const std::array<QString, 4> meanings{
        tr("A bag of springs in the surface alone, which its tethers keep in form: for a first look, and for "
           "what is thin as a skin"),
        tr("The surface also resists bending, as a wall %1 mm thick does; Tissue has the thickness. For "
           "bowel, bladder, vessels")
            .arg(numberText(1000 * usualWallThickness)),
        tr("Nodes at the vertices and in layers beneath them, so that both sides of the wall can be touched "
           "and it keeps its form: for bowel, bladder, vessels, open or closed"),
        tr("Nodes and springs throughout the body, so that it resists being pressed: for liver, kidney, "
           "spleen")};
    for (std::size_t i = 0; i < names.size(); ++i) {
        auto* button = new QRadioButton(names[i], this);
        button->setObjectName(QStringLiteral("importBody%1").arg(i));
        button->setToolTip(meanings[i]);
        m_bodies->addButton(button, static_cast<int>(i));
        m_work[i] = quietLabel({}, this);
        m_work[i]->setObjectName(QStringLiteral("importWork%1").arg(i));
        m_work[i]->setToolTip(tr("How long a step of the motion takes, beside that of the hollow organ that "
                                 "bends freely"));
        addRow(form, button, m_work[i]);
    }
    m_bodies->button(Hollow)->setChecked(true);
    connect(m_bodies, &QButtonGroup::idClicked, this, &BodyQuestion::showChoice);
}

void BodyQuestion::addDetail(QFormLayout* form) {
    m_detail->setObjectName(QStringLiteral("importDetail"));
    m_detail->addItems({tr("every vertex"), tr("fewer nodes under the full surface"), tr("one stiff piece")});
    guardFromWheel(*m_detail);
    const auto addField = [&](const QString& caption, QWidget* field) {
        QLabel* label = quietLabel(caption, this, field);
        field->setAccessibleName(withoutMnemonic(caption));
        form->addRow(label, field);
    };
    addField(tr("Simula&te"), m_detail);
    addField(tr("&Nodes"), m_nodes);
    m_nodes->setObjectName(QStringLiteral("importNodes"));
    m_thickness->setObjectName(QStringLiteral("importThickness"));
    m_thickness->setValue(usualWallThickness);
    addField(tr("W&all thickness"), m_thickness);
    m_suggestion->setObjectName(QStringLiteral("importSuggestion"));
    m_suggestion->setWordWrap(true);
    // The room for it is kept, so that nothing moves.
    m_suggestion->setMinimumHeight(3 * m_suggestion->fontMetrics().lineSpacing());
    m_suggestion->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    form->addRow(m_suggestion);
    connect(m_detail, qOverload<int>(&QComboBox::currentIndexChanged), this, &BodyQuestion::showChoice);
    connect(m_nodes, &NumberField::valueEdited, this, [this](double nodes) {
        (body() == Solid ? m_solidNodes : m_fewerNodes) = nodes;
        showWork();
        m_suggestion->setText(suggestion());
    });
    connect(m_thickness, &NumberField::valueEdited, this, &BodyQuestion::showChoice);
}

void BodyQuestion::setSurface(std::size_t vertices, bool isClosed, double meanEdge) {
    m_vertices = vertices;
    m_meanEdge = meanEdge;
    m_isClosed = isClosed;
    showChoice();
}

Detail::Kind BodyQuestion::kind() const {
    return body() == Solid || body() == Prisms ? Detail::Kind::Filled
                                               : static_cast<Detail::Kind>(m_detail->currentIndex());
}

LatticeFilling BodyQuestion::wall() const {
    const double thickness = m_thickness->value().value_or(usualWallThickness);
    return {LatticeKind::Prisms, 0, thickness, usualLayers(m_meanEdge, thickness)};
}

double BodyQuestion::wallNodes() const {
    return static_cast<double>(m_vertices) * (wall().layers + 1);
}

BodyChoice BodyQuestion::choice() const {
    if (body() == Prisms) return {{Detail::Kind::Filled, 0, wall()}, false};
    BodyChoice choice{{kind(), static_cast<std::size_t>(m_nodes->value().value_or(0))}, false};
    if (choice.detail.kind == Detail::Kind::Nodes && choice.detail.nodes >= m_vertices)
        choice.detail.kind = Detail::Kind::EveryVertex;
    choice.resistsBending = body() == Walled && choice.detail.kind != Detail::Kind::Rigid;
    return choice;
}

QString BodyQuestion::refusal() const {
    return body() == Solid && !m_isClosed
               ? tr("An open surface cannot be filled: close it, or choose a hollow organ")
               : QString();
}

void BodyQuestion::showChoice() {
    enable(m_detail, body() != Solid && body() != Prisms, tr("What moves under the drawn surface"),
           body() == Prisms
               ? tr("A wall of prisms has nodes at every vertex and in each layer")
               : tr("The nodes of a solid body lie on a lattice, not at the surface's vertices"));
    enable(m_thickness, body() == Prisms, tr("How far the wall reaches inwards from the surface"),
           tr("Only a wall of prisms is as thick as is said here"));
    showNodes();
    showWork();
    m_suggestion->setText(suggestion());
    emit changed();
}

void BodyQuestion::showNodes() {
    const std::pair asked(body(), kind());
    const bool isOther = m_shownNodes != asked;
    m_shownNodes = asked;
    const bool isChosen = kind() == Detail::Kind::Nodes || body() == Solid;
    enable(m_nodes, isChosen, tr("More nodes follow a deformation closer and take longer"),
           body() == Prisms ? tr("A wall of prisms has nodes at every vertex and in each layer")
                            : tr("Choose fewer nodes, or a solid organ, to say how many"));
    // A number that was refused stays to be mended.
    if (isChosen && !isOther && !m_nodes->refusal().isEmpty()) return;
    m_nodes->setFormat(body() == Solid ? countFormat(fewestSolidNodes, mostSolidNodes)
                                       : countFormat(fewestVertices, static_cast<double>(m_vertices)));
    m_nodes->setValue(body() == Solid ? m_solidNodes : body() == Prisms ? wallNodes() : hollowNodes());
}

/// Of the organ, were it hollow.
double BodyQuestion::hollowNodes() const {
    const auto all = static_cast<double>(m_vertices);
    switch (static_cast<Detail::Kind>(m_detail->currentIndex())) {
    case Detail::Kind::Nodes:
        return std::min(m_fewerNodes, all);
    case Detail::Kind::Rigid:
        return static_cast<double>(motionModelNodes);
    default:
        return all;
    }
}

void BodyQuestion::showWork() {
    const bool isRigid = m_detail->currentIndex() == static_cast<int>(Detail::Kind::Rigid);
    const double nodes = std::max(1.0, hollowNodes());
    const std::array<double, 4> work{1, isRigid ? 1 : workOfBending, workOfPrisms * wallNodes() / nodes,
                                     workOfSolid * m_solidNodes / nodes};
    for (std::size_t i = 0; i < work.size(); ++i)
        m_work[i]->setText(i == Hollow ? tr("1 ×") : tr("about %1 ×").arg(numberText(work[i], 1)));
}

/// How many nodes are worth to be chosen, and why.
QString BodyQuestion::suggestion() const {
    if (!refusal().isEmpty())
        return tr("The surface is open and cannot be filled: close slits and fill holes below.");
    if (body() == Solid)
        return tr("About %1 nodes fill the body. Model → Inside… then shows them, and chooses others.")
            .arg(countText(static_cast<std::size_t>(m_solidNodes)));
    if (body() == Prisms)
        return tr("%1 layers of prisms. Where the organ is too narrow the wall is thinner: Model → Inside… "
                  "then says at how many vertices, and takes other thicknesses.")
            .arg(wall().layers);
    if (m_vertices <= suggestedNodes)
        return tr("Recommended: every vertex. So few usually move in real time.");
    return tr("Recommended: %1 nodes under the full surface. So few usually move in real time; %2 may not. "
              "What this machine does is told under Measure.")
        .arg(countText(suggestedNodes), countText(m_vertices));
}

} // namespace esm
