package program;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Sphere;
import enlightenment.image.Image;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.net.RenderServer;
import enlightenment.net.RenderWorker;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.awt.image.BufferedImage;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLong;

/** A program that embeds the renderer as any would; it fails where something is not as it was promised. */
public final class Embedding {
    private Embedding() {}

    public static void main(String[] args) throws Exception {
        inCode();
        fromFile(Path.of(args[0]));
        cancelled();
        Meshes.areRendered();
        withoutTheLibraryForCbor(RenderServer.class, "start");
        withoutTheLibraryForCbor(RenderWorker.class, "run");
        for (String absent : new String[] {"java.management", "jdk.management", "jdk.httpserver", "info.picocli"}) {
            check(ModuleLayer.boot().findModule(absent).isEmpty(), absent + " is there");
        }
        System.out.println("embedded");
    }

    /** A white ball before black, the light behind the eye: its middle is bright, the corners are black. */
    private static Scene ball() {
        return Scene.builder()
                .size(32, 32)
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, -4), ExactPoint.of(0, 0, 0), Vec3.Y, 45))
                .light(new Light.Sphere(ExactPoint.of(0, 0, -9), 1, DisplayRgb.WHITE))
                .object(
                        Sphere.of(ExactPoint.of(0, 0, 0), 1),
                        Material.Matte.of(new Texture.Solid(DisplayRgb.WHITE)))
                .build();
    }

    private static void inCode() {
        Scene scene = ball();
        AtomicLong last = new AtomicLong();
        RenderResult result = Renderer.render(
                scene, RenderSettings.of(scene), (done, total, soFar) -> last.set(done == total ? total : 0), () -> false);
        check(last.get() > 0, "the listener was not told of the end");
        Image image = result.image();
        int[] pixels = image.toArgb();
        check(pixels.length == 32 * 32, "there are " + pixels.length + " pixels");
        check((pixels[16 * 32 + 16] & 0xff) > 128, "the ball is dark");
        check(pixels[0] == 0xff000000, "the corner is not black");
        BufferedImage picture = Pictures.buffered(image);
        check(Arrays.equals(picture.getRGB(0, 0, 32, 32, null, 0, 32), pixels), "the picture is another");
    }

    private static void fromFile(Path file) throws Exception {
        Scene scene = SceneReader.read(file);
        Image image = Renderer.render(scene, RenderSettings.of(scene));
        check(Arrays.stream(image.toArgb()).distinct().count() > 1, "the picture of " + file + " is of one colour");
    }

    private static void cancelled() {
        Scene scene = ball();
        RenderResult result = Renderer.render(scene, RenderSettings.of(scene), (done, total, soFar) -> {}, () -> true);
        check(!result.complete(), "a render that was cancelled at once is complete");
    }

    /** The first thing these say is what is missing, whatever they are called with. */
    private static void withoutTheLibraryForCbor(Class<?> type, String name) throws Exception {
        int called = 0;
        for (Method method : type.getMethods()) {
            if (!Modifier.isStatic(method.getModifiers()) || !method.getName().equals(name)) {
                continue;
            }
            Object[] nothing = new Object[method.getParameterCount()];
            for (int i = 0; i < nothing.length; i++) {
                nothing[i] = method.getParameterTypes()[i] == int.class ? (Object) 0 : null;
            }
            try {
                method.invoke(null, nothing);
                check(false, type + " needs nothing");
            } catch (InvocationTargetException e) {
                check(
                        e.getCause() instanceof IllegalStateException
                                && e.getCause().getMessage().contains("jackson-dataformat-cbor"),
                        type + " fails with " + e.getCause());
            }
            called++;
        }
        check(called > 0, type + " has no " + name);
    }

    private static void check(boolean holds, String otherwise) {
        if (!holds) {
            throw new AssertionError(otherwise);
        }
    }
}
