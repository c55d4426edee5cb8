package enlightenment.view;

import enlightenment.image.Image;
import enlightenment.render.RenderResult;
import enlightenment.render.aov.AuxiliaryPicture;
import enlightenment.scene.Scene;
import enlightenment.view.frame.Frame;
import enlightenment.view.frame.FrameBuilder;
import enlightenment.view.frame.Kept;
import enlightenment.view.frame.PictureNoise;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.IntFunction;

/**
 * A layer of the view: its values, its picture in false colours, and the key to them.
 *
 * @param numbers raw values of each pixel; the three components are equal except for albedo and normals
 * @param image the layer in colours, of the size of {@code numbers}
 * @param explanation the meaning of the colours, in words
 * @param marks labels of the colour scale at equal distances; empty without a scale
 * @param names names of objects or materials by their number; null for other layers
 * @param legend names and shares of the false colours
 * @param rmse root mean square over all pixels in displayed units, estimated for the error, measured for the difference; else empty
 * @param noise the difference in displayed units that the estimated errors of both pictures alone would cause; empty if unknown
 */
record LayerPicture(
        Image numbers,
        Image image,
        String explanation,
        List<String> marks,
        IntFunction<String> names,
        Legend legend,
        OptionalDouble rmse,
        OptionalDouble noise) {

    /** Thrown for a layer that is not available; the message is the reason. */
    static final class Missing extends Exception {
        private static final long serialVersionUID = 1;

        Missing(String message) {
            super(message);
        }

        static Missing yet(Layer layer) {
            return new Missing(layer.word() + " is not there yet");
        }
    }

    /** Whether {@link #of} returns the layer; also true for the picture itself, if there is one. */
    static boolean exists(Layer layer, Snapshot view) {
        Frame frame = view.frame();
        return switch (layer) {
            case PICTURE, SAMPLES -> frame != null;
            case DENOISED -> DenoisedPicture.exists(view);
            case ALBEDO, NORMAL, DEPTH, OBJECT, MATERIAL ->
                view.layers().of(source(layer)).isPresent();
            case ERROR -> frame != null && frame.detail().noise().isPresent();
            case DIFFERENCE ->
                frame != null && view.kept() != null && view.kept().isComparable(frame.image());
        };
    }

    /**
     * Makes the picture of a layer from the last render of it.
     *
     * @param layer any in false colours
     * @param materials materials of the layers' scene; used for {@link Layer#MATERIAL} alone
     * @throws Missing if the layer is not available, or not yet
     */
    static LayerPicture of(Layer layer, Snapshot view, MaterialIndex materials) throws Missing {
        if (!exists(layer, view)) {
            throw Missing.yet(layer);
        }
        return switch (layer) {
            case PICTURE, DENOISED -> throw new IllegalArgumentException(layer + " is not in false colours");
            case ALBEDO, NORMAL, DEPTH -> plain(source(layer), numbers(layer, view));
            case OBJECT -> {
                Scene scene = view.layers()
                        .of(RenderResult.Auxiliary.OBJECT)
                        .orElseThrow()
                        .scene();
                yield named(layer, numbers(layer, view), n -> PixelProbe.object(scene, n)
                        .orElseThrow());
            }
            case MATERIAL -> named(layer, materials(numbers(layer, view), materials), materials::name);
            case SAMPLES ->
                plain(RenderResult.Auxiliary.SAMPLES, view.frame().detail().samples());
            case ERROR -> error(view.frame(), view.exposure());
            case DIFFERENCE -> difference(view);
        };
    }

    private static Image numbers(Layer layer, Snapshot view) {
        return view.layers().of(source(layer)).orElseThrow().image();
    }

    private static RenderResult.Auxiliary source(Layer layer) {
        return layer.sources().get(0);
    }

    /** The picture without grain, as displayed. */
    static LayerPicture denoised(Image image) {
        return new LayerPicture(
                image,
                image,
                "the picture without grain, for looking: nothing is known of its error",
                List.of(),
                null,
                Legend.NONE,
                OptionalDouble.empty(),
                OptionalDouble.empty());
    }

    private static LayerPicture plain(RenderResult.Auxiliary kind, Image numbers) {
        AuxiliaryPicture shown = AuxiliaryPicture.withoutScale(kind, numbers);
        return new LayerPicture(
                numbers,
                shown.image(),
                shown.explanation(),
                shown.marks(),
                null,
                Legend.NONE,
                OptionalDouble.empty(),
                OptionalDouble.empty());
    }

    private static LayerPicture named(Layer layer, Image numbers, IntFunction<String> names) {
        Image image = AuxiliaryPicture.withoutScale(RenderResult.Auxiliary.OBJECT, numbers)
                .image();
        return new LayerPicture(
                numbers,
                image,
                "one colour for each " + layer.word() + "; black: nothing there",
                List.of(),
                names,
                Legend.of(numbers, image, names),
                OptionalDouble.empty(),
                OptionalDouble.empty());
    }

    private static Image materials(Image objects, MaterialIndex materials) {
        float[] numbers = objects.toArray();
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = materials.of((int) numbers[i]);
        }
        return new Image(objects.width(), objects.height(), numbers);
    }

    private static LayerPicture error(Frame frame, double exposure) {
        PictureNoise noise = frame.detail().noise().orElseThrow();
        Image numbers = noise.map(FrameBuilder.curve(frame.image(), exposure));
        double rmse = noise.rmse(FrameBuilder.curve(frame.image(), exposure));
        AuxiliaryPicture shown = AuxiliaryPicture.withoutScale(RenderResult.Auxiliary.ERROR, numbers);
        return new LayerPicture(
                numbers,
                shown.image(),
                "estimated standard error, as displayed, over 3 x 3 pixels",
                shown.marks(),
                null,
                Legend.NONE,
                OptionalDouble.of(rmse),
                OptionalDouble.empty());
    }

    private static LayerPicture difference(Snapshot view) {
        Kept kept = view.kept();
        Image now = view.shown();
        Image numbers = kept.difference(now);
        AuxiliaryPicture shown = AuxiliaryPicture.withoutScale(RenderResult.Auxiliary.ERROR, numbers);
        OptionalDouble noise = view.frame()
                .detail()
                .noise()
                .filter(n -> kept.rmse().isPresent())
                .map(n -> OptionalDouble.of(
                        Math.hypot(n.rmse(now.curve()), kept.rmse().getAsDouble())))
                .orElse(OptionalDouble.empty());
        return new LayerPicture(
                numbers,
                shown.image(),
                "difference from A, as displayed, each pixel's root mean square over its components",
                shown.marks(),
                null,
                Legend.NONE,
                OptionalDouble.of(rootMeanSquare(numbers)),
                noise);
    }

    private static double rootMeanSquare(Image numbers) {
        double sum = 0;
        for (int y = 0; y < numbers.height(); y++) {
            double row = 0;
            for (int x = 0; x < numbers.width(); x++) {
                double value = numbers.component(x, y, 0);
                row += value * value;
            }
            sum += row;
        }
        return Math.sqrt(sum / ((double) numbers.width() * numbers.height()));
    }
}
