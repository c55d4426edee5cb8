package enlightenment.bench;

import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Triangle;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Primitives;
import enlightenment.primitive.Ray;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** One ray against one primitive: 4,096 rays from a ball around it, about half of which hit. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class PrimitiveBenchmark {
    private static final int RAYS = 4096;

    @Param({
        "sphere",
        "rectangle",
        "tilted rectangle",
        "disk",
        "cylinder",
        "cone",
        "frustum",
        "cube",
        "box",
        "torus",
        "triangle"
    })
    public String shape;

    private Primitive primitive;
    private final Ray[] rays = new Ray[RAYS];

    @Setup
    public void setUp() {
        primitive = Primitives.place(shape(), SceneFrame.WORLD);
        Random r = new Random(1);
        for (int i = 0; i < RAYS; i++) {
            Vec3 o = new Vec3(r.nextGaussian(), r.nextGaussian(), r.nextGaussian())
                    .normalized()
                    .times(8);
            Vec3 to = new Vec3(r.nextGaussian(), r.nextGaussian(), r.nextGaussian()).times(0.6);
            rays[i] = Ray.of(o, to.minus(o).normalized());
        }
    }

    private Shape shape() {
        ExactPoint o = ExactPoint.ORIGIN;
        return switch (shape) {
            case "sphere" -> Sphere.of(o, 1);
            case "rectangle" ->
                new Rectangle(
                        ExactPoint.of(-1, -1, 0),
                        ExactPoint.of(-1, 1, 0),
                        ExactPoint.of(1, 1, 0),
                        ExactPoint.of(1, -1, 0));
            case "tilted rectangle" ->
                new Rectangle(
                        ExactPoint.of(-1, -1, 0),
                        ExactPoint.of(-1, 1, 1),
                        ExactPoint.of(1, 1, 1),
                        ExactPoint.of(1, -1, 0));
            case "disk" -> new Disk(o, new Vec3(1, 2, 3), 1);
            case "cylinder" -> new Cylinder(ExactPoint.of(-0.5, -1, 0), ExactPoint.of(0.5, 1, 0.25), 0.7, true);
            case "cone" -> new Cone(ExactPoint.of(-0.5, -1, 0), ExactPoint.of(0.5, 1, 0.25), 1, 0, true);
            case "frustum" -> new Cone(ExactPoint.of(-0.5, -1, 0), ExactPoint.of(0.5, 1, 0.25), 1, 0.5, true);
            case "cube" -> new Cube(o, 1.2, new Vec3(20, 30, 40));
            case "box" -> new Box(ExactPoint.of(-0.8, -0.7, -0.6), ExactPoint.of(0.6, 0.7, 0.8));
            case "torus" -> new Torus(o, new Vec3(1, 2, 3), 0.8, 0.3);
            default -> new Triangle(ExactPoint.of(-1, -1, 0), ExactPoint.of(-1, 1, 1), ExactPoint.of(1, -1, 0.5));
        };
    }

    @Benchmark
    @OperationsPerInvocation(RAYS)
    public double nearest() {
        double sum = 0;
        for (Ray ray : rays) {
            double t = primitive.nearest(ray, Double.MAX_VALUE);
            sum += t < Double.MAX_VALUE ? t : 0;
        }
        return sum;
    }
}
