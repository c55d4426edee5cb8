package enlightenment.cli.picture;

import enlightenment.cli.terminal.CliException;
import enlightenment.render.RenderResult;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;

/** A render that was stopped in the middle, and whose picture so far has been written. */
public final class StoppedRender {
    private StoppedRender() {}

    /** @param rest what the picture shows where nothing is finished, in words that go on from its share; may be empty */
    public static CliException after(RenderResult result, PictureOutput picture, String rest) {
        return after(result, picture, rest, "");
    }

    /** @param further what there is beside the picture, in words that end the sentence; may be empty */
    public static CliException after(RenderResult result, PictureOutput picture, String rest, String further) {
        RenderSettings.Crop region = result.report().settings().region();
        boolean isOfPaths = result.report().sampling().method().kind() == Method.Kind.SPLATS;
        long percent = 100 * result.report().pixels() / ((long) region.width() * region.height());
        return CliException.failed("stopped: " + picture.name() + " holds " + percent + " % of "
                + (isOfPaths ? "its paths" : "the picture" + rest)
                + further);
    }
}
