package enlightenment.view;

import enlightenment.render.Film;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.OptionalInt;

/**
 * A request for a final render.
 *
 * @param scene the scene with the camera and exposure of the view, and with motion blur
 * @param film images and material tables that are shared with the pictures of the view
 * @param frame the animation frame, counted from 0; empty if no track has been applied
 * @param settings size, method, budget and threads
 */
record RenderOrder(Scene scene, Film film, OptionalInt frame, RenderSettings settings) {}
