#pragma once

#include "app/editor/edits/preparation_edits.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/section.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QPushButton>

namespace esm {

/// What stands beside a step of a photo's preparation.
struct StepWords {
    QString shown{};  ///< a word or two, as there is little room
    QString inFull{}; ///< in the tool tip; empty where that is all
};

/// How the selected photo is prepared: before and after beside each other, and a check box for each step with
/// what was found in words.
class PreparationPanel : public Section {
    Q_OBJECT

public:
    explicit PreparationPanel(PreparationEdits& edits, QWidget* parent = nullptr);

signals:
    /// The photo is to be shown in a window of its own, where it is masked, cropped and its lens corrected.
    void largeViewAsked();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /// A check box and what is known of its step.
    struct Step {
        QCheckBox* box;
        QLabel* words;
    };

    void layOut();
    void connectControls();
    Step addStep(const QString& text, const char* name, QWidget* beside = nullptr);
    /// A step that is switched on with numbers that were known before, or off.
    template<typename Part> void connectKept(Step& step, Part PhotoPreparation::*part, const QString& text);
    void show();
    void showFailure();
    void showRemark(const PreparationWish& wish);
    void showPictures(const TextureLayer* layer);
    void showSteps(const TextureLayer* layer);
    void enableSteps(const TextureLayer* layer);
    static void showWords(Step& step, bool on, const StepWords& words);
    QString highlightWords(const PhotoPreparation& wanted) const;

    PreparationEdits& m_edits;
    QLabel *m_before, *m_after, *m_warning, *m_remark;
    QGridLayout* m_steps;
    NumberField* m_evenLightField;
    Step m_field, m_strokes, m_highlights, m_evenLight, m_whiteBalance, m_match, m_lens, m_crop, m_adjustment;
    QPushButton* m_large;
    PhotoPreparation m_last; ///< what the check boxes bring back
    std::shared_ptr<const Photo> m_lastOf;
};

} // namespace esm
