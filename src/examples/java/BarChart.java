import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Rectangle;
import enlightenment.image.ImageFiles;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshBuilder;
import enlightenment.mesh.TriangleMesh;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.OptionalInt;

/**
 * Numbers as bars in daylight: a scene that is made in code alone, with a mesh of its own on top of the largest bar.
 *
 * <pre>
 * java -cp enlightenment-0.1.0.jar:jackson-core.jar src/examples/java/BarChart.java chart.png 640x400 3 5 8 13 9 6
 * </pre>
 */
public final class BarChart {
    /** The largest bar has this height; bars stand one unit apart. */
    private static final double HEIGHT = 3;

    private static final double HALF_WIDTH = 0.36;
    private static final DisplayRgb[] COLORS = {
        new DisplayRgb(0.20, 0.45, 0.75), new DisplayRgb(0.90, 0.55, 0.15), new DisplayRgb(0.30, 0.65, 0.35)
    };

    private BarChart() {}

    public static void main(String[] args) throws IOException {
        Path picture = Path.of(args[0]);
        String[] size = args[1].split("x");
        double[] numbers =
                Arrays.stream(args).skip(2).mapToDouble(Double::parseDouble).toArray();
        Scene scene = chart(numbers, Integer.parseInt(size[0]), Integer.parseInt(size[1]));
        RenderSettings settings = RenderSettings.of(scene).withSamples(64);
        ImageFiles.writePng(Renderer.render(scene, settings), picture);
    }

    static Scene chart(double[] numbers, int width, int height) {
        double largest = Arrays.stream(numbers).max().orElse(1);
        double middle = (numbers.length - 1) / 2.0;
        double distance = Math.max(numbers.length, 5);
        Scene.Builder scene = Scene.builder()
                .name("bars")
                .size(width, height)
                .camera(new Camera.Perspective(
                        ExactPoint.of(-distance, 4.5, -1.5 * distance), ExactPoint.of(0, 0.4 * HEIGHT, 0), Vec3.Y, 32))
                // Physical light: a bright overcast sky, and a sun that gives the bars their shadows.
                .shading(new Shading.Physical(OptionalInt.empty(), Rgb.gray(0.55)))
                .light(new Light.Distant(new Vec3(-0.6, -1, 0.35), Rgb.gray(1.6)))
                .object(ground(6 * distance), matte(new DisplayRgb(0.93, 0.93, 0.93)));
        for (int i = 0; i < numbers.length; i++) {
            double x = i - middle;
            double top = HEIGHT * numbers[i] / largest;
            scene.object(
                    new Box(
                            ExactPoint.of(x - HALF_WIDTH, 0, -HALF_WIDTH),
                            ExactPoint.of(x + HALF_WIDTH, top, HALF_WIDTH)),
                    matte(COLORS[i % COLORS.length]));
            if (numbers[i] == largest) {
                scene.object(Mesh.of(marker(x, top)), matte(new DisplayRgb(0.80, 0.15, 0.15)));
            }
        }
        return scene.build();
    }

    /** A pyramid on its tip, above the middle of a bar. */
    private static TriangleMesh marker(double x, double top) {
        MeshBuilder mesh = new MeshBuilder();
        int tip = mesh.vertex(x, top + 0.1, 0);
        int first = mesh.vertex(x - 0.25, top + 0.5, -0.25);
        mesh.vertex(x - 0.25, top + 0.5, 0.25);
        mesh.vertex(x + 0.25, top + 0.5, 0.25);
        mesh.vertex(x + 0.25, top + 0.5, -0.25);
        for (int k = 0; k < 4; k++) {
            // Counterclockwise, seen from outside.
            mesh.triangle(tip, first + k, first + (k + 1) % 4);
        }
        mesh.triangle(first, first + 2, first + 1);
        mesh.triangle(first, first + 3, first + 2);
        return mesh.build();
    }

    private static Rectangle ground(double side) {
        return new Rectangle(
                ExactPoint.of(-side, 0, -side),
                ExactPoint.of(-side, 0, side),
                ExactPoint.of(side, 0, side),
                ExactPoint.of(side, 0, -side));
    }

    private static Material matte(DisplayRgb color) {
        return Material.Matte.of(Texture.of(color));
    }
}
