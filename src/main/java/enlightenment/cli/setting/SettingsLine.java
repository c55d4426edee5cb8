package enlightenment.cli.setting;

import enlightenment.cli.option.DecimalNumber;
import enlightenment.scene.ChosenSettings;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;

/** The settings that a picture depends on, in one line that never changes its form. */
public final class SettingsLine {
    private SettingsLine() {}

    /**
     * The line for settings as they are.
     *
     * @param frame the frame that was asked for, or null
     */
    public static String of(RenderSettings s, Integer frame) {
        StringBuilder line = new StringBuilder("method=").append(s.method());
        line.append(" size=").append(s.width()).append('x').append(s.height());
        line.append(" antialias=").append(s.antialias());
        if (s.budget().samples().isPresent()) {
            line.append(" samples=")
                    .append(DecimalNumber.plain(s.budget().samples().getAsDouble()));
        }
        if (s.budget().error().isPresent()) {
            line.append(" error=").append(DecimalNumber.plain(s.budget().error().getAsDouble()));
        }
        List<Method.Setting> settings = new ArrayList<>(Method.influences(s.method()));
        settings.addAll(ChosenSettings.Common.ALL);
        for (Method.Setting setting : settings) {
            line.append(' ').append(setting.key()).append('=').append(s.chosen().value(setting));
        }
        if (s.crop().isPresent()) {
            line.append(" crop=").append(CropConverter.typed(s.crop().get()));
        }
        if (frame != null) {
            line.append(" frame=").append(frame);
        }
        return line.toString();
    }

    /** The line for a picture whose number of samples was planned: with it the same bytes can be made again. */
    public static String replayable(RenderSettings s, double plannedSamples, Integer frame) {
        return of(s.withBudget(s.budget().replayable(plannedSamples)), frame);
    }
}
