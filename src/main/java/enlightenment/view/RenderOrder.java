package enlightenment.view;

import enlightenment.render.Film;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.OptionalInt;

/**
 * A final render that was asked for.
 *
 * @param scene as it is seen, with motion blur
 * @param film what its pictures have in common with those of the view
 * @param frame of its animation, counted from 0; empty if it is as the file's own numbers say
 * @param settings all of them
 */
record RenderOrder(Scene scene, Film film, OptionalInt frame, RenderSettings settings) {}
