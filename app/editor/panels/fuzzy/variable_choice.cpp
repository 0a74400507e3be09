#include "app/editor/panels/fuzzy/variable_choice.h"

#include "widgets/fuzzy/term_scale.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/spoken.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QStandardItemModel>

namespace esm {

namespace {

enum VariableRole { SideRole = Qt::UserRole, IndexRole };

} // namespace

VariableChoice::VariableChoice(QWidget* parent)
    : QWidget(parent), m_list(new QComboBox(this)), m_more(new QToolButton(this)) {
    m_list->setObjectName(QStringLiteral("variableChoice"));
    nameChoice(*m_list, tr("Variable"));
    m_list->setToolTip(tr("The variable whose terms are shown"));
    m_list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_list->setMinimumContentsLength(10);
    guardFromWheel(*m_list);
    m_more->setObjectName(QStringLiteral("quietButton"));
    m_more->setText(QStringLiteral("···"));
    m_more->setToolTip(tr("Add, rename, move or remove variables"));
    m_more->setAccessibleName(m_more->toolTip());
    m_more->setPopupMode(QToolButton::InstantPopup);
    m_more->setFocusPolicy(Qt::TabFocus);
    auto* menu = new QMenu(m_more);
    menu->setToolTipsVisible(true);
    menu->setObjectName(QStringLiteral("variableMenu"));
    m_more->setMenu(menu);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(m_list, 1);
    row->addWidget(m_more);

    m_rename = menu->addAction(tr("Re&name…"), this, &VariableChoice::renameRequested);
    m_up = menu->addAction(tr("Move &up"), this, [this] { emit moveRequested(-1); });
    m_down = menu->addAction(tr("Move &down"), this, [this] { emit moveRequested(1); });
    m_remove = menu->addAction(tr("&Remove"), this, &VariableChoice::removeRequested);
    menu->addSeparator();
    m_addInput = menu->addAction(tr("Add &input"), this, [this] { emit addRequested(FuzzySide::Inputs); });
    m_addOutput = menu->addAction(tr("Add &output"), this, [this] { emit addRequested(FuzzySide::Outputs); });
    m_rename->setToolTip(tr("Give the variable another name; rules follow"));
    m_addInput->setToolTip(tr("Another slider that rules may ask about"));
    m_addOutput->setToolTip(tr(
        "Another value that rules may conclude; “spring constant”, “viscosity” and “mass” set the tissue"));
    connect(m_list, qOverload<int>(&QComboBox::activated), this, [this](int row) {
        emit chosen({static_cast<FuzzySide>(m_list->itemData(row, SideRole).toInt()),
                     m_list->itemData(row, IndexRole).toUInt()});
    });
}

void VariableChoice::show(const FuzzySystem& system, const VariablePlace& chosen) {
    const QSignalBlocker quiet(m_list);
    QStringList names{tr("Inputs")};
    for (const FuzzyVariable& input : system.inputs)
        names << readableName(input.name);
    names << tr("Outputs");
    for (const FuzzyVariable& output : system.outputs)
        names << readableName(output.name);
    // While a corner is dragged they stay.
    if (names != m_names) {
        m_names = names;
        m_list->clear();
        addVariables(tr("Inputs"), FuzzySide::Inputs, system.inputs);
        addVariables(tr("Outputs"), FuzzySide::Outputs, system.outputs);
    }
    const std::size_t before = chosen.side == FuzzySide::Inputs ? 1 : system.inputs.size() + 2;
    m_list->setCurrentIndex(static_cast<int>(before + chosen.index)); // behind the titles
    enableActions(system, chosen);
}

void VariableChoice::addVariables(const QString& title, FuzzySide side,
                                  const std::vector<FuzzyVariable>& variables) {
    m_list->addItem(title);
    auto* model = qobject_cast<QStandardItemModel*>(m_list->model());
    model->item(m_list->count() - 1)->setFlags(Qt::NoItemFlags);
    for (std::size_t i = 0; i < variables.size(); ++i) {
        m_list->addItem(readableName(variables[i].name));
        m_list->setItemData(m_list->count() - 1, static_cast<int>(side), SideRole);
        m_list->setItemData(m_list->count() - 1, static_cast<uint>(i), IndexRole);
    }
}

void VariableChoice::enableActions(const FuzzySystem& system, const VariablePlace& chosen) {
    const std::size_t count = variablesOf(system, chosen.side).size();
    const bool isInput = chosen.side == FuzzySide::Inputs;
    enable(m_up, chosen.index > 0, tr("Sliders stand in this order"), tr("It is the first already"));
    enable(m_down, chosen.index + 1 < count, tr("Sliders stand in this order"), tr("It is the last already"));
    enable(m_remove, count > 1, tr("Remove the variable and the rules that speak of it"),
           isInput ? tr("A system has at least one input") : tr("A system has at least one output"));
}

} // namespace esm
