#pragma once

#include <QMenu>

namespace esm {

/// Fills a menu with the files that were opened last and an entry that forgets them.
class RecentMenu : public QObject {
    Q_OBJECT

public:
    RecentMenu(QMenu& menu, QObject* parent);

    /// Shows the files as they are remembered now.
    void fill();

signals:
    /// @param file its full path
    void chosen(const QString& file);

private:
    QMenu& m_menu;
};

} // namespace esm
