package enlightenment.view;

import enlightenment.denoise.Denoiser;
import enlightenment.denoise.NoisyPicture;
import enlightenment.image.Image;
import enlightenment.render.RenderResult;
import enlightenment.view.frame.Frame;
import enlightenment.view.frame.FrameBuilder;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/**
 * The picture of a view without grain. It takes longer than a pass, so that it is made again only when there are half as many samples more, or
 * the last. For use by one thread at a time.
 */
final class DenoisedPicture {
    private static final double MORE = 1.5;

    /** The frame that grain was removed from last, and the result, of its curve; null before the first. */
    private Frame of;

    private Image last;

    /** Whether there are passes at full resolution and the layers of the same generation that guide the filter. */
    static boolean exists(Snapshot view) {
        Frame frame = view.frame();
        return frame != null
                && !frame.detail().quarters().isEmpty()
                && Layer.DENOISED.sources().stream()
                        .allMatch(kind -> guide(view, kind).isPresent());
    }

    private static Optional<Image> guide(Snapshot view, RenderResult.Auxiliary kind) {
        Frame frame = view.frame();
        return view.layers()
                .of(kind)
                .filter(layer -> layer.generation() == frame.generation() && layer.shrink() == frame.shrink())
                .map(Layers.Numbers::image);
    }

    /**
     * The picture without grain at the exposure of the view.
     *
     * @param view of the session
     * @param session tells when the view has changed
     * @throws LayerPicture.Missing if it does not {@link #exists exist} yet, or the view changes meanwhile
     */
    LayerPicture at(Snapshot view, ViewSession session) throws LayerPicture.Missing {
        if (!exists(view)) {
            throw LayerPicture.Missing.yet(Layer.DENOISED);
        }
        Frame frame = view.frame();
        if (!isRecent(frame)) {
            try {
                float[] rgb = Denoiser.denoise(
                        noisy(view),
                        Runtime.getRuntime().availableProcessors(),
                        () -> !session.isCurrent(frame.generation()));
                last = new Image(
                        frame.image().width(),
                        frame.image().height(),
                        rgb,
                        frame.image().curve());
                of = frame;
            } catch (CancellationException e) {
                throw new LayerPicture.Missing("the view has changed");
            }
        }
        return LayerPicture.denoised(last.withCurve(FrameBuilder.curve(last, view.exposure())));
    }

    private boolean isRecent(Frame frame) {
        return of != null
                && of.generation() == frame.generation()
                && (of.samples() == frame.samples() || !frame.isFinal() && frame.samples() < MORE * of.samples());
    }

    private static NoisyPicture noisy(Snapshot view) {
        Image image = view.frame().image();
        List<float[]> quarters =
                view.frame().detail().quarters().stream().map(Image::toArray).toList();
        float[] all = new float[quarters.size() * quarters.get(0).length];
        for (int i = 0; i < all.length; i++) {
            all[i] = quarters.get(i / 3 % quarters.size())[i / (3 * quarters.size()) * 3 + i % 3];
        }
        return new NoisyPicture(
                image.width(),
                image.height(),
                image.toArray(),
                all,
                guide(view, RenderResult.Auxiliary.ALBEDO).orElseThrow().toArray(),
                guide(view, RenderResult.Auxiliary.NORMAL).orElseThrow().toArray(),
                guide(view, RenderResult.Auxiliary.POSITION).orElseThrow().toArray());
    }
}
