#include "app/editor/panels/fuzzy/spare_systems_button.h"

#include "app/editor/dialogs/shipped_systems.h"
#include "widgets/inputs/enabling.h"

#include <QMenu>

namespace esm {

SpareSystemsButton::SpareSystemsButton(Document& document, QWidget* parent)
    : QToolButton(parent), m_document(document) {
    setObjectName(QStringLiteral("quietButton"));
    setText(QStringLiteral("···"));
    setToolTip(tr("Remove fuzzy systems of this project that no region uses"));
    setAccessibleName(toolTip());
    setPopupMode(QToolButton::InstantPopup);
    setFocusPolicy(Qt::TabFocus);
    auto* menu = new QMenu(this);
    menu->setToolTipsVisible(true);
    menu->setObjectName(QStringLiteral("spareSystemsMenu"));
    setMenu(menu);
    connect(menu, &QMenu::aboutToShow, this, &SpareSystemsButton::fill);
}

void SpareSystemsButton::fill() {
    menu()->clear();
    for (const SharedSystem& system : systemsOf(m_document.project()))
        if (!isShipped(*system)) addSystem(system);
    if (!menu()->isEmpty()) return;
    QAction* none = menu()->addAction(tr("Remove"));
    enable(none, false, {}, tr("The project has no fuzzy system of its own; those that ship always stay"));
}

void SpareSystemsButton::addSystem(const SharedSystem& system) {
    QStringList users;
    for (const Region* region : usersOf(m_document.project(), *system))
        users << QString::fromStdString(region->name);
    QAction* remove = menu()->addAction(tr("Remove “%1”").arg(shownName(*system)));
    enable(remove, users.isEmpty(), tr("No region uses it"),
           tr("Used by %1").arg(users.join(QStringLiteral(", "))));
    connect(remove, &QAction::triggered, this, [this, system] {
        m_document.edit(tr("Remove fuzzy system"),
                        [&](Project& project) { removeSpareSystem(project, *system); });
    });
}

} // namespace esm
