#include "app/editor/dialogs/system_questions.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/box_setup.h"
#include "app/editor/dialogs/shipped_systems.h"
#include "core/fuzzy/rule_text.h"
#include "widgets/fuzzy/term_scale.h"
#include "widgets/inputs/number_text.h"

#include <QInputDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>

namespace esm {

namespace {

constexpr std::size_t mostRulesShown = 5;

} // namespace

std::optional<std::string> askVariableName(QWidget& window, const QString& title,
                                           const std::string& proposal) {
    bool accepted = false;
    const QString name = ask(window, [&] {
        return QInputDialog::getText(&window, title, QObject::tr("Name of the variable"), QLineEdit::Normal,
                                     readableName(proposal), &accepted);
    });
    return accepted ? std::optional(ruleName(name.toStdString())) : std::nullopt;
}

bool mayTakeRulesAlong(QWidget& window, const FuzzySystem& system, const QString& what,
                       const std::vector<std::size_t>& rules) {
    if (rules.empty()) return true;
    QStringList texts;
    for (std::size_t i = 0; i < std::min(rules.size(), mostRulesShown); ++i)
        texts << QString::fromStdString(ruleText(system, system.rules[rules[i]]));
    if (rules.size() > mostRulesShown)
        texts << QObject::tr("and %1 more").arg(countText(rules.size() - mostRulesShown));
    return ask(window, [&] {
        QMessageBox box(
            QMessageBox::Question, QObject::tr("Remove %1").arg(what),
            rules.size() == 1
                ? QObject::tr("With %1 goes the rule that speaks of it.").arg(what)
                : QObject::tr("With %1 go %2 rules that speak of it.").arg(what, countText(rules.size())),
            QMessageBox::Cancel, &window);
        setUpBox(box, "rulesGoBox");
        box.setInformativeText(texts.join('\n'));
        QPushButton* remove = box.addButton(QObject::tr("&Remove"), QMessageBox::AcceptRole);
        box.setDefaultButton(remove);
        box.exec();
        return box.clickedButton() == remove;
    });
}

// Keys that were meant for what is edited must not answer: letters choose no button, Enter and the space bar
// cancel.
std::optional<Reach> askReach(QWidget& window, const FuzzySystem& system, const QString& selected,
                              const std::vector<const Region*>& users) {
    const QStringList names = namesOf(users);
    return ask(window, [&]() -> std::optional<Reach> {
        QMessageBox box(QMessageBox::Question, QObject::tr("Edit fuzzy system"),
                        QObject::tr("%1 regions use the fuzzy system “%2”. For whom is the change?")
                            .arg(countText(users.size()), shownName(system)),
                        QMessageBox::Cancel, &window);
        box.setObjectName(QStringLiteral("reachBox"));
        box.setInformativeText(
            QObject::tr("They are: %1.\n\nA copy gets a name of its own and is for “%2” alone; the others "
                        "keep theirs. The answer holds until another region is selected.")
                .arg(QStringLiteral("“%1”").arg(names.join(QStringLiteral("”, “"))), selected));
        QPushButton* all =
            box.addButton(QObject::tr("For all %1 regions").arg(users.size()), QMessageBox::AcceptRole);
        QPushButton* copy = box.addButton(QObject::tr("A copy for this one"), QMessageBox::AcceptRole);
        all->setObjectName(QStringLiteral("everyRegion"));
        copy->setObjectName(QStringLiteral("copyForOne"));
        box.setDefaultButton(QMessageBox::Cancel);
        box.exec();
        if (box.clickedButton() == all) return Reach::EveryRegion;
        return box.clickedButton() == copy ? std::optional(Reach::CopyForOne) : std::nullopt;
    });
}

} // namespace esm
