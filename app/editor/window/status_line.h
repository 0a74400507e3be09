#pragma once

#include "app/editor/window/passing_time.h"
#include "app/editor/workers/preview_run.h"

#include "widgets/inputs/elided_label.h"

#include <QStatusBar>
#include <QTimer>

#include <optional>

namespace esm {

/// How close the time step is to the largest stable one.
class StabilityGauge : public QWidget {
    Q_OBJECT

public:
    explicit StabilityGauge(QWidget* parent = nullptr);
    /// @param share step over the largest stable step, 0 to 1; below zero while it is not known
    void setShare(double share);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double m_share = -1;
};

/// The state at a glance, at the bottom of the window.
class StatusLine : public QObject {
    Q_OBJECT

public:
    explicit StatusLine(QStatusBar& bar, PassingTime clock = sinceStart());

    void countPicture() { ++m_pictures; }
    void showStatus(const PreviewStatus& status);
    /// Something that was done; goes by itself.
    void showMessage(const QString& text);
    /// The same of what the program did by itself, where no message of another kind is still to be read.
    void showAside(const QString& text);
    /// Why the photos are not on the organ; stays until it is empty.
    void showPictureFailure(const QString& reason);
    /// Why unsaved work is not written down; stays until it is empty.
    void showJournalFailure(const QString& reason);
    /// What is computed beside the window; stays until it is empty.
    void showWork(const QString& work);
    /// What the preview leaves out, and more of it for who asks; stays while nothing else is to be said.
    void showNote(const QString& note, const QString& explanation);

private:
    QLabel* addLabel(const QString& name, const QString& widestText, const QString& toolTip);
    void showRate();
    void showLasting();
    void showText(const QString& text, const QString& toolTip, bool warning);
    void explainStep(const PreviewStatus& status);
    void showSpeed(const PreviewStatus& status);
    void setText(QLabel& label, const QString& text, bool warning);
    QString problem() const;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void makeRoom();

    QStatusBar& m_bar;
    QLabel *m_rate, *m_realTime, *m_step, *m_stability;
    ElidedLabel* m_message;
    StabilityGauge* m_gauge;
    QWidget* m_captionedGauge;
    QTimer m_rateTimer, m_messageTimer;
    PassingTime m_clock;
    qint64 m_since; ///< ms, pictures are counted
    int m_pictures = 0;
    bool m_isAside = false; ///< what is shown in passing
    QString m_failure, m_pictureFailure, m_journalFailure, m_recovery, m_shortening, m_work, m_note,
        m_noteExplained;
};

} // namespace esm
