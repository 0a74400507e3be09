#include "app/editor/window/recent_menu.h"

#include "app/editor/document/file_memory.h"

#include <QDir>
#include <QFileInfo>

namespace esm {

namespace {

/// "&1  liver.esm – /data/organs": names alone repeat.
QString entryText(int number, const QString& file) {
    const QFileInfo info(file);
    const QString text = QObject::tr("%1 – %2").arg(info.fileName(), QDir::toNativeSeparators(info.path()));
    return QStringLiteral("&%1  ").arg(number) + QString(text).replace('&', QStringLiteral("&&"));
}

} // namespace

RecentMenu::RecentMenu(QMenu& menu, QObject* parent) : QObject(parent), m_menu(menu) {
    m_menu.setObjectName(QStringLiteral("recentMenu"));
    // Another window may have opened files since.
    connect(&m_menu, &QMenu::aboutToShow, this, &RecentMenu::fill);
    fill();
}

void RecentMenu::fill() {
    m_menu.clear();
    const QStringList files = recentFiles();
    if (files.isEmpty()) {
        m_menu.addAction(tr("No file was opened yet"))->setEnabled(false);
        return;
    }
    for (const QString& file : files)
        // Later: the menu may be filled anew while its entry is still at work.
        connect(
            m_menu.addAction(entryText(m_menu.actions().size() + 1, file)), &QAction::triggered, this,
            [this, file] { emit chosen(file); }, Qt::QueuedConnection);
    m_menu.addSeparator();
    connect(
        m_menu.addAction(tr("&Clear this list")), &QAction::triggered, this,
        [this] {
            clearRecentFiles();
            fill();
        },
        Qt::QueuedConnection);
}

} // namespace esm
