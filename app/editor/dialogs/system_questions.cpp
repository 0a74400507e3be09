#include "app/editor/dialogs/system_questions.h"

#include "app/editor/dialogs/ask.h"
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
        box.setObjectName(QStringLiteral("rulesGoBox"));
        box.setInformativeText(texts.join('\n'));
        QPushButton* remove = box.addButton(QObject::tr("Remove"), QMessageBox::AcceptRole);
        box.setDefaultButton(remove);
        box.exec();
        return box.clickedButton() == remove;
    });
}

} // namespace esm
