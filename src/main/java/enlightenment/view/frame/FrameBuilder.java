package enlightenment.view.frame;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;
import enlightenment.render.RenderResult;
import java.util.List;
import java.util.Optional;

/** Accumulates the passes of one {@link Shot} into pictures. For use by one thread. */
public final class FrameBuilder {
    private final long generation;
    private final PictureSum sum = new PictureSum();
    private final PassQuarters quarters = new PassQuarters();
    private float[] samples;
    private int shrink;
    private List<ErrorPoint> errors = List.of();

    /** @param generation the generation of the shot */
    public FrameBuilder(long generation) {
        this.generation = generation;
    }

    /**
     * Adds a pass and returns the picture so far.
     *
     * @param result the render of the pass, with {@link RenderResult.Auxiliary#SAMPLES}
     * @param isFinal whether this is the last pass
     * @param seconds time since the change of the view, greater than 0
     * @param exposure the exposure of the view, in stops
     */
    public Frame add(PassPlan pass, RenderResult result, boolean isFinal, double seconds, double exposure) {
        if (pass.shrink() != shrink) {
            shrink = pass.shrink();
            samples = null;
        }
        Image counts = count(result.auxiliary().get(RenderResult.Auxiliary.SAMPLES));
        if (shrink == 1) {
            quarters.add(result.image(), pass.samples());
        }
        Image image = shrink > 1 ? result.image() : sum.add(result.image(), pass.samples());
        Optional<PictureNoise> noise = shrink > 1 ? Optional.empty() : sum.noise();
        int all = pass.before() + pass.samples();
        noise.ifPresent(n -> errors =
                ErrorPoint.with(errors, new ErrorPoint(seconds, all, n.rmse(curve(image, exposure)), exposure)));
        FrameDetail detail = new FrameDetail(counts, noise, errors, seconds, quarters.means());
        return new Frame(generation, image, all, shrink, isFinal, detail);
    }

    /** Adds the sample counts of a pass and returns the sums. */
    private Image count(Image more) {
        float[] added = more.toArray();
        if (samples != null) {
            for (int i = 0; i < added.length; i++) {
                added[i] += samples[i];
            }
        }
        samples = added;
        return new Image(more.width(), more.height(), added);
    }

    /** The display curve of a picture at an exposure; a display-referred picture keeps its own. */
    public static DisplayCurve curve(Image image, double exposure) {
        return image.encoding() == Color.Encoding.DISPLAY
                ? image.curve()
                : image.curve().withExposure(exposure);
    }
}
