package enlightenment.view;

import enlightenment.listen.SmallHttp;
import enlightenment.math.InvalidValueException;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;

/** Parser of the settings of a final render from the parameters of a request. */
final class RenderForm {
    /** The most pixels of a final render, whose files are kept in memory until they are fetched. */
    static final int MOST_PIXELS = 1 << 25;

    /** Bits per component of the PNG file, whose rounding is part of its error. */
    private static final int PNG_DEPTH = 8;

    /** The least error that can be requested: smaller ones are below the rounding of floats. */
    private static final double LEAST_ERROR = 1e-7;

    private RenderForm() {}

    /**
     * The settings of the scene, with those of the request in their place.
     *
     * @param threads number of rendering threads
     * @throws BadParameter if a parameter is not a number, or out of range
     * @throws InvalidValueException if the method is unknown or does not support the scene
     */
    static RenderSettings settings(Scene scene, SmallHttp.Request request, int threads) {
        RenderSettings usual = RenderSettings.of(scene);
        int width = side(request, "width", usual.width());
        int height = side(request, "height", usual.height());
        if ((long) width * height > MOST_PIXELS) {
            throw new BadParameter("a picture of " + width + "x" + height + " pixels is larger than the " + MOST_PIXELS
                    + " that a view renders: the command render makes larger ones");
        }
        RenderSettings sized =
                usual.withSize(width, height).withBudget(budget(request)).withThreads(threads);
        return withMethod(sized, scene, request);
    }

    private static int side(SmallHttp.Request request, String name, int usual) {
        return request.value(name).isEmpty() ? usual : (int) ViewActions.number(request, name, 1, Scene.MAX_SIDE);
    }

    private static RenderSettings.Budget budget(SmallHttp.Request request) {
        RenderSettings.Budget budget = RenderSettings.Budget.NONE;
        if (request.value("samples").isPresent()) {
            budget = budget.withSamples(ViewActions.number(request, "samples", 1, RenderSettings.Budget.MAX_SAMPLES));
        }
        if (request.value("error").isPresent()) {
            budget = budget.withError(ViewActions.number(request, "error", LEAST_ERROR, 1))
                    .withDepth(PNG_DEPTH);
        }
        return budget;
    }

    private static RenderSettings withMethod(RenderSettings settings, Scene scene, SmallHttp.Request request) {
        if (request.value("method").isEmpty()) {
            return settings;
        }
        Method method = Method.named(request.value("method").get());
        Method.requireSupport(method, scene);
        return settings.withMethod(method);
    }
}
