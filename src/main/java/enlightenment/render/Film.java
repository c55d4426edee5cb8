package enlightenment.render;

import enlightenment.check.Check;
import enlightenment.scene.Animation;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.light.SceneImages;
import java.util.Objects;
import java.util.function.BooleanSupplier;
import java.util.function.IntFunction;

/**
 * The frames of an animated scene, each of them a request to the renderer like any other. Frames do not depend on each other: any of them may be
 * rendered, in any order, on any machine, to the same bytes as by {@link Renderer#render(RenderRequest)}. What a film adds is that the image files
 * of its scenes are read once and kept in memory, for as long as the film is referred to, and that tables of materials which two frames have in
 * common are made once.
 *
 * <pre>{@code
 * SceneFrames file = SceneFrames.of(Path.of("scenes/fire-and-ice-tween.json"));
 * Film film = Film.of(file.read().animation().orElseThrow(), file::read);
 * for (int n = 0; n < film.frames(); n++) {
 *     ImageFiles.writePng(film.render(film.request(n)).image(), Path.of("frame-" + n + ".png"));
 * }
 * }</pre>
 *
 * <p>The scenes may be made in code as well. A film may be used by several threads.
 *
 */
public final class Film {
    private final int frames;
    private final double framesPerSecond;
    private final IntFunction<Scene> scenes;
    private final SceneImages files = new SceneImages();

    private Film(int frames, double framesPerSecond, IntFunction<Scene> scenes) {
        Check.that(frames >= 1, "frames", "must be at least 1, not " + frames);
        Check.positive("framesPerSecond", framesPerSecond);
        this.frames = frames;
        this.framesPerSecond = framesPerSecond;
        this.scenes = Objects.requireNonNull(scenes, "scenes");
    }

    /**
     * A film of scenes from anywhere.
     *
     * @param frames their number, at least 1; they are counted from 0
     * @param framesPerSecond greater than 0 and finite
     * @param scenes makes the scene of a frame, each time that it is asked for
     * @throws enlightenment.math.InvalidValueException if the numbers are out of range
     */
    public static Film of(int frames, double framesPerSecond, IntFunction<Scene> scenes) {
        return new Film(frames, framesPerSecond, scenes);
    }

    /**
     * A film as an animation describes it.
     *
     * @param scenes makes the scene of a frame, each time that it is asked for: for a file
     *     {@link enlightenment.scene.json.SceneReader.Frames#read(int)}
     */
    public static Film of(Animation animation, IntFunction<Scene> scenes) {
        return new Film(animation.frames(), animation.framesPerSecond(), scenes);
    }

    /** The number of frames, at least 1. */
    public int frames() {
        return frames;
    }

    /** The number of frames per second; greater than 0. */
    public double framesPerSecond() {
        return framesPerSecond;
    }

    /**
     * The scene of a frame.
     *
     * @param frame counted from 0
     * @throws IndexOutOfBoundsException if there is no such frame
     * @throws enlightenment.scene.SceneException if its scene cannot be used
     */
    public Scene scene(int frame) {
        return scenes.apply(Objects.checkIndex(frame, frames));
    }

    /** A frame's picture, as its scene asks for it, on all processors; fails as {@link #scene} does. */
    public RenderRequest request(int frame) {
        Scene scene = scene(frame);
        return RenderRequest.of(scene, RenderSettings.of(scene));
    }

    /**
     * Fails where rendering a frame would because of its camera, lights, shapes or surroundings, but builds nothing to render with and does
     * not look at the textures of surfaces, which are those of all frames: {@link Renderer#check} does.
     *
     * @param frame the frame's {@link #scene}
     * @throws enlightenment.scene.SceneException if it cannot be rendered, with all lights that are too much for their size
     */
    public void check(Scene frame) {
        SceneCompiler.check(frame, files);
    }

    /**
     * Chooses the method of renders of a scene at one size, as {@link Renderer#choose} does, and prepares the scene for all of them: those that
     * are requested with {@link RenderRequest.MethodChoice#with} do not prepare it again. Takes as much memory as a render, for as long as it is kept.
     *
     * @param scene of this film, seen by any camera
     * @param cancelled asked from several threads at once
     * @throws enlightenment.scene.SceneException if the scene cannot be used
     * @throws enlightenment.math.InvalidValueException if a setting cannot be used
     * @throws java.util.concurrent.CancellationException if it was cancelled, or the calling thread interrupted, before that was done
     */
    public RenderRequest.MethodChoice prepare(Scene scene, RenderSettings settings, BooleanSupplier cancelled) {
        return Renderer.prepare(scene, settings, files, cancelled);
    }

    /**
     * Renders a frame as {@link Renderer#render(RenderRequest)} does: the same bytes and failures. An image file is read by the first
     * frame that needs it; if it changes afterwards, the film does not see it.
     */
    public RenderResult render(RenderRequest request) {
        return Renderer.render(request, files);
    }
}
