#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

#include <QDir>
#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>

using namespace esm;

namespace {

QString read(const QString& file) {
    QFile page(file);
    EXPECT_TRUE(page.open(QIODevice::ReadOnly)) << qPrintable(file);
    return QString::fromUtf8(page.readAll());
}

QString bare(QString text) {
    return text.remove('&').remove(QChar(0x2026)).trimmed();
}

/// What is written of the menus: "*File → Open…* (Ctrl+O)".
QStringList problemsOf(const QString& page, const QMenuBar& menus) {
    static const QRegularExpression mention(QStringLiteral("\\*(\\w+) → ([^*]+)\\*(?: \\(([^);,]+)\\))?"));
    QStringList problems;
    for (auto found = mention.globalMatch(read(page)); found.hasNext();) {
        const auto match = found.next();
        const QAction* named = nullptr;
        for (const QAction* menu : menus.actions())
            if (menu->menu() && bare(menu->text()) == match.captured(1))
                for (const QAction* action : menu->menu()->actions())
                    if (bare(action->text()) == bare(match.captured(2))) named = action;
        const QString key = match.captured(3);
        if (!named || (!key.isEmpty() && named->shortcut() != QKeySequence(key)))
            problems << page.section('/', -1) + ": " + match.captured(0);
    }
    return problems;
}

QStringList pages() {
    const QDir guide(QStringLiteral(ESM_SOURCE_DIR "/docs/user-guide"));
    QStringList files{QStringLiteral(ESM_SOURCE_DIR "/README.md")};
    for (const QString& name : guide.entryList({QStringLiteral("*.md")}))
        files << guide.filePath(name);
    return files;
}

} // namespace

TEST(ActionsGuide, NamesMenusAndKeysAsTheyAre) {
    MainWindow window(makeSample("tube"));
    ASSERT_GT(pages().size(), 6);
    for (const QString& page : pages())
        EXPECT_EQ(problemsOf(page, *window.menuBar()).join('\n').toStdString(), "");
}

TEST(ActionsGuide, HasEveryPictureThatItShowsAndShowsEveryPicture) {
    static const QRegularExpression shown(
        QStringLiteral("!\\[[^]]+\\]\\((?:docs/user-guide/)?pictures/([^)]+)\\)"));
    QStringList named;
    for (const QString& page : pages())
        for (auto found = shown.globalMatch(read(page)); found.hasNext();)
            named << found.next().captured(1);
    named.removeDuplicates();
    named.sort();
    EXPECT_EQ(
        QDir(QStringLiteral(ESM_SOURCE_DIR "/docs/user-guide/pictures")).entryList(QDir::Files, QDir::Name),
        named);
}
