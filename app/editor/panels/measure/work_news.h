#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QStackedWidget>
#include <QTimer>

#include <optional>

namespace esm {

/// What is to be said of work beside the window, or how far it is once it takes a while. As high as a long
/// sentence, so that what stands below stays where it is.
class WorkNews : public QStackedWidget {
    Q_OBJECT

public:
    /// @param name of the work, by which its parts are found: "press" for "pressMessage" and "pressProgress"
    /// @param whatIsDone what the bar tells screen readers
    WorkNews(const QString& name, const QString& whatIsDone, QWidget* parent = nullptr);

    /// How much of the work is done, 0 to 1; none while nothing is done.
    void setProgress(std::optional<double> done);
    void say(const QString& text, bool warns);

private:
    void showPage();

    QLabel* m_message;
    QProgressBar* m_progress;
    QTimer m_patience; ///< until work is long enough for a bar
    bool m_isWorking = false;
};

} // namespace esm
