package enlightenment.view;

import enlightenment.camera.Camera;
import enlightenment.listen.SmallHttp;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneWriter;

/** Actions of a view, by the parameters of requests. */
final class ViewActions {
    private static final double TURN = 360;
    private static final double MOST_HEIGHTS = 100;
    private static final double LEAST_FACTOR = 0.01;
    private static final double MOST_FACTOR = 100;
    private static final int MOST_SIDE = 1 << 16;

    private final ViewSession session;
    private final SceneLoader loader;
    private final ScenePreparation preparation;
    private final RenderPages renders;

    /** The scene for which a window camera has been given an aim; null if none. */
    private Scene aimed;

    ViewActions(ViewSession session, SceneLoader loader, ScenePreparation preparation, RenderPages renders) {
        this.session = session;
        this.loader = loader;
        this.preparation = preparation;
        this.renders = renders;
    }

    /**
     * Performs the action of a request.
     *
     * @throws BadParameter if the action is unknown or a parameter invalid
     * @throws enlightenment.math.InvalidValueException if the view does not support the action
     * @throws SceneLoader.Refusal if the view cannot be saved
     */
    void act(SmallHttp.Request request) throws SceneLoader.Refusal {
        String action = request.value("action").orElse("");
        switch (action) {
            case "orbit" -> {
                aimWindow();
                double right = number(request, "x", -TURN, TURN);
                double up = number(request, "y", -TURN, TURN);
                session.move(v -> v.orbit(right, up));
            }
            case "pan" -> {
                double x = number(request, "x", -MOST_HEIGHTS, MOST_HEIGHTS);
                double y = number(request, "y", -MOST_HEIGHTS, MOST_HEIGHTS);
                ViewSize size = session.snapshot().size();
                session.move(v -> v.pan(x, y, size.aspect()));
            }
            case "dolly" -> {
                aimWindow();
                double factor = number(request, "x", LEAST_FACTOR, MOST_FACTOR);
                session.move(v -> v.dolly(factor));
            }
            case "roll" -> {
                double degrees = number(request, "x", -TURN, TURN);
                session.move(v -> v.roll(degrees));
            }
            case "field-of-view" -> {
                double degrees = number(request, "x", 0, TURN);
                session.move(v -> v.withFieldOfView(degrees));
            }
            case "exposure" ->
                session.expose(number(request, "x", -Scene.Display.MAX_EXPOSURE, Scene.Display.MAX_EXPOSURE));
            case "size" ->
                session.resize((int) number(request, "x", 1, MOST_SIDE), (int) number(request, "y", 1, MOST_SIDE));
            case "aim", "focus" -> pick(action, request);
            case "keep" -> session.keep();
            case "forget" -> session.forget();
            case "reset" -> reset();
            case "frame" -> loader.show((int) number(request, "x", 0, Integer.MAX_VALUE));
            case "render" -> renders.start(request);
            case "cancel" -> renders.cancel();
            case "save" -> save();
            default -> throw new BadParameter("there is no such action");
        }
    }

    private void reset() {
        synchronized (this) {
            aimed = null;
        }
        session.reset();
    }

    private void save() throws SceneLoader.Refusal {
        loader.save();
        session.note("saved");
    }

    private void pick(String action, SmallHttp.Request request) {
        PixelProbe pixel = probe(number(request, "x", 0, 1), number(request, "y", 0, 1));
        if (!pixel.isHit()) {
            throw new BadParameter("there is nothing at that place");
        }
        if (action.equals("focus")) {
            session.move(v -> v.focusedOn(pixel.exactPoint()));
        } else {
            synchronized (this) {
                aimed = session.snapshot().scene();
            }
            session.move(v -> v.aimedAt(pixel.exactPoint()));
        }
    }

    /**
     * Traces the ray of a pixel. Synchronized, as the first ray may have to prepare the scene.
     *
     * @param x place in the picture, 0..1 from its left
     * @param y place in the picture, 0..1 from its top
     */
    synchronized PixelProbe probe(double x, double y) {
        Shot shot = session.shot();
        int column = Math.min((int) (x * shot.size().width()), shot.size().width() - 1);
        int row = Math.min((int) (y * shot.size().height()), shot.size().height() - 1);
        return PixelProbe.of(shot, preparation, column, row);
    }

    /** Aims a window camera at the hit in the middle of the picture, once for each scene: it has no focus distance. */
    private synchronized void aimWindow() {
        Snapshot now = session.snapshot();
        if (now.viewpoint() == null || !(now.viewpoint().camera() instanceof Camera.Window) || now.scene() == aimed) {
            return;
        }
        PixelProbe middle = probe(0.5, 0.5);
        if (middle.isHit()) {
            session.move(v -> v.aimedAt(middle.exactPoint()));
        }
        aimed = now.scene();
    }

    /** The camera of the view as JSON of a scene file. */
    String camera() {
        return SceneWriter.toJson(session.shot().scene().camera()) + "\n";
    }

    /** A numeric parameter of a request; fails unless it is in {@code least..most}. */
    static double number(SmallHttp.Request request, String name, double least, double most) {
        String text = request.value(name).orElse("");
        try {
            double v = Double.parseDouble(text);
            if (v >= least && v <= most) {
                return v;
            }
        } catch (NumberFormatException e) {
            // Refused below, as a number out of range is.
        }
        throw new BadParameter(name + " must be a number in " + least + ".." + most);
    }
}
