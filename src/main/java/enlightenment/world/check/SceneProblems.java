package enlightenment.world.check;

import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.InvalidValueException;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.SceneException.Problem;
import enlightenment.scene.Shading;
import enlightenment.world.SceneCompiler;
import enlightenment.world.light.SceneImages;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;

/**
 * Finds the problems that keep a scene from being rendered and that its text alone does not show: all of them, where a render ends at the
 * first.
 */
public final class SceneProblems {
    /** Reads an image that no render would read. */
    @FunctionalInterface
    public interface ImageReader {
        /** @throws IOException if it cannot be read; the message names the file */
        void read(Path file) throws IOException;
    }

    private final Scene scene;
    private final SceneImages images;
    private final List<Problem> problems = new ArrayList<>();

    private final ImageReader other;

    private SceneProblems(Scene scene, SceneImages images, ImageReader other) {
        this.scene = scene;
        this.other = other;
        this.images = images;
    }

    /**
     * Compiles the scene, and reads all images that it names, each once.
     *
     * @param other reads images that are named but that no object uses
     * @throws SceneException with all problems: images, what the method cannot render, lights with too much power for their size, and the
     *     first of any others
     */
    public static void check(Scene scene, RenderSettings settings, ImageReader other) {
        check(scene, settings, new SceneImages(), other);
    }

    static void check(Scene scene, RenderSettings settings, SceneImages images, ImageReader other) {
        SceneProblems found = new SceneProblems(scene, images, other);
        found.readImages();
        found.attempt(() -> Method.requireSupport(settings.method(), scene));
        found.attempt(() -> SceneCompiler.check(scene));
        if (found.problems.isEmpty()) {
            found.attempt(() -> SceneCompiler.compile(scene, settings, images));
        }
        if (!found.problems.isEmpty()) {
            throw new SceneException(found.problems);
        }
    }

    private void attempt(Runnable work) {
        try {
            work.run();
        } catch (SceneException e) {
            problems.addAll(e.problems());
        } catch (InvalidValueException e) {
            problems.addAll(SceneException.of(e).problems());
        }
    }

    private void readImages() {
        Shading.Background background = scene.shading() instanceof Shading.Physical p ? p.background() : null;
        Texture.File around = background instanceof Shading.Background.Picture p ? p.picture() : null;
        Set<Texture> needed = needed();
        scene.textures().forEach((name, texture) -> {
            if (!(texture instanceof Texture.File file)) {
                return;
            }
            try {
                if (file.equals(around)) {
                    images.around(background);
                }
                if (needed.contains(file)) {
                    images.read(file, scene.shading().model() == Shading.Model.PHYSICAL);
                } else if (!file.equals(around)) {
                    other.read(file.file());
                }
            } catch (SceneException e) {
                Problem problem = e.problems().get(0);
                if (problem.pointer().endsWith("/texture")) {
                    tell(name, problem.message());
                } else if (!problems.contains(problem)) {
                    // The problem is not the file's, which may have several names.
                    problems.add(problem);
                }
            } catch (IOException e) {
                tell(name, e.getMessage());
            }
        });
    }

    private void tell(String texture, String problem) {
        problems.add(new Problem("", 0, 0, "/textures/" + SceneException.escaped(texture) + "/file", problem));
    }

    /** The textures of surfaces and of projectors, which compiling reads. */
    private Set<Texture> needed() {
        Set<Material> materials = Collections.newSetFromMap(new IdentityHashMap<>());
        scene.objects().forEach(object -> {
            materials.addAll(object.faces());
            materials.add(object.material());
        });
        Set<Texture> textures = new HashSet<>();
        for (Light light : scene.lights()) {
            if (light instanceof Light.Projector projector) {
                textures.add(projector.picture());
            }
        }
        materials.forEach(material -> addTextures(material, textures));
        return textures;
    }

    private static void addTextures(Material material, Set<Texture> textures) {
        textures.add(material.color());
        textures.addAll(material.textures());
        material.parts().forEach(part -> addTextures(part, textures));
    }
}
