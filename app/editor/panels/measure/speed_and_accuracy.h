#pragma once

#include "app/editor/document/document.h"
#include "app/editor/workers/preview.h"

#include <QTimer>

namespace esm {

/// How fast and how exactly this machine can compute the organ's motion, by every method: measured on
/// request, seen by what the user wishes, and one of them chosen. What was measured is part of the document.
class SpeedAndAccuracy : public QObject {
    Q_OBJECT

public:
    SpeedAndAccuracy(Document& document, Preview& preview, QObject* parent = nullptr);

    /// Every run, and what is best by the wishes; null until measured.
    const Tradeoff* tradeoff() const { return m_tradeoff ? &*m_tradeoff : nullptr; }
    const TradeoffWishes& wishes() const { return m_wishes; }
    void setMostError(double error); ///< relative to the motion
    /// Of computing, s; a run that would take longer is left out.
    double mostSecondsPerRun() const { return m_mostSecondsPerRun; }
    void setMostSecondsPerRun(double seconds) { m_mostSecondsPerRun = seconds; }
    /// Of the runs, the one by which the tissue moves; none while the program chooses, or where it is
    /// another.
    std::optional<std::size_t> runInUse() const;
    /// Tissue or scene are no longer those that were measured, or that the step in use was chosen for.
    bool isOutdated() const { return m_isOutdated; }
    /// Whether the tissue is yet to be compared, once edits rest.
    bool isComparing() const { return m_rest.isActive(); }

    /// Both say in the window what keeps them from it.
    void measure(QWidget* window);
    void use(std::size_t run, QWidget* window);
    void useAutomatic();

signals:
    /// Others were measured, or none any more; before changed().
    void runsChanged();
    /// What any of these gives.
    void changed();

private:
    void follow(const Change& change);
    void workOut();
    void compare();

    Document& m_document;
    Preview& m_preview;
    TradeoffWishes m_wishes;
    double m_mostSecondsPerRun = 1;
    std::optional<Tradeoff> m_tradeoff;
    QTimer m_rest; ///< until the tissue is compared
    bool m_isOutdated = false;
};

} // namespace esm
