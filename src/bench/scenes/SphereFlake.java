import java.io.BufferedOutputStream;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Writes a flake of spheres over a floor: java src/bench/scenes/SphereFlake.java [enlightenment|mitsuba|povray] [depth]
 *
 * <p>Every sphere carries nine of a third of its radius: six around its equator, three nearer to its pole. Depth 4, the default, has
 * 7,381 spheres. One spherical light; 800 x 600 pixels of 16 samples with one light sample each. For Mitsuba 3 and POV-Ray 3.7 the
 * same geometry, camera and light; only the shading is each program's own.
 */
public final class SphereFlake {
    private static final double LATITUDE = Math.asin(2 / Math.sqrt(6));

    private final List<double[]> balls = new ArrayList<>();

    private SphereFlake() {}

    public static void main(String[] arguments) {
        String format = arguments.length > 0 ? arguments[0] : "enlightenment";
        int depth = arguments.length > 1 ? Integer.parseInt(arguments[1]) : 4;
        SphereFlake flake = new SphereFlake();
        flake.grow(new double[] {0, 0, 0}, 0.5, new double[] {0, 0, 1}, depth);
        PrintStream out = new PrintStream(new BufferedOutputStream(System.out, 1 << 20), false);
        switch (format) {
            case "enlightenment" -> flake.enlightenment(out);
            case "mitsuba" -> flake.mitsuba(out);
            case "povray" -> flake.povray(out);
            default -> throw new IllegalArgumentException(format);
        }
        out.flush();
    }

    private void grow(double[] center, double radius, double[] pole, int depth) {
        balls.add(new double[] {center[0], center[1], center[2], radius});
        if (depth == 0) {
            return;
        }
        // Two unit vectors across the pole.
        double[] helper = Math.abs(pole[0]) < 0.6 ? new double[] {1, 0, 0} : new double[] {0, 1, 0};
        double[] a = unit(cross(helper, pole));
        double[] b = cross(pole, a);
        for (int k = 0; k < 9; k++) {
            double latitude = k < 6 ? 0 : LATITUDE;
            double longitude = k < 6 ? k * Math.PI / 3 : Math.PI / 6 + (k - 6) * 2 * Math.PI / 3;
            double[] direction = new double[3];
            double[] child = new double[3];
            for (int c = 0; c < 3; c++) {
                direction[c] = Math.cos(latitude) * (Math.cos(longitude) * a[c] + Math.sin(longitude) * b[c])
                        + Math.sin(latitude) * pole[c];
                child[c] = center[c] + radius * 4 / 3 * direction[c];
            }
            grow(child, radius / 3, direction, depth - 1);
        }
    }

    private static double[] cross(double[] p, double[] q) {
        return new double[] {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    }

    private static double[] unit(double[] v) {
        double length = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        return new double[] {v[0] / length, v[1] / length, v[2] / length};
    }

    private void enlightenment(PrintStream out) {
        out.println(
                """
                { "name": "Sphere flake", "image": { "width": 800, "height": 600 },
                  "camera": { "type": "perspective", "eye": [2.1, 1.3, 1.7], "lookAt": [0, 0, 0], "up": [0, 0, 1], "fieldOfView": 30 },
                  "shading": { "model": "classic", "ambient": 0.1, "shadow": 0, "background": "#14385b" },
                  "render": { "antialias": 4, "shadowSamples": 1 },
                  "materials": { "floor": { "type": "matte", "color": "#ffbf55" }, "ball": { "type": "matte", "color": "#ffe673" } },
                  "lights": [ { "type": "sphere", "center": [4, 3, 2], "radius": 0.3, "color": "#ffffff" } ],
                  "objects": [
                    { "type": "rectangle", "material": "floor", "corners": [[12, 12, -0.5], [-12, 12, -0.5], [-12, -12, -0.5], [12, -12, -0.5]] }""");
        for (double[] s : balls) {
            out.printf(
                    Locale.ROOT,
                    "    , { \"type\": \"sphere\", \"center\": [%.9f, %.9f, %.9f], \"radius\": %.9f, \"material\": \"ball\" }%n",
                    s[0],
                    s[1],
                    s[2],
                    s[3]);
        }
        out.println("  ] }");
    }

    private void mitsuba(PrintStream out) {
        out.println(
                """
                <scene version="3.0.0">
                  <integrator type="direct"><integer name="emitter_samples" value="1"/><integer name="bsdf_samples" value="0"/></integrator>
                  <sensor type="perspective"><string name="fov_axis" value="x"/><float name="fov" value="30"/>
                    <transform name="to_world"><lookat origin="2.1, 1.3, 1.7" target="0, 0, 0" up="0, 0, 1"/></transform>
                    <sampler type="independent"><integer name="sample_count" value="16"/></sampler>
                    <film type="hdrfilm"><integer name="width" value="800"/><integer name="height" value="600"/><rfilter type="box"/></film>
                  </sensor>
                  <bsdf type="twosided" id="floor"><bsdf type="diffuse"><rgb name="reflectance" value="1, 0.75, 0.33"/></bsdf></bsdf>
                  <bsdf type="diffuse" id="ball"><rgb name="reflectance" value="1, 0.9, 0.45"/></bsdf>
                  <shape type="sphere"><point name="center" x="4" y="3" z="2"/><float name="radius" value="0.3"/>
                    <emitter type="area"><rgb name="radiance" value="200, 200, 200"/></emitter></shape>
                  <shape type="rectangle"><transform name="to_world"><scale x="12" y="12"/><translate z="-0.5"/></transform><ref id="floor"/></shape>""");
        for (double[] s : balls) {
            out.printf(
                    Locale.ROOT,
                    "  <shape type=\"sphere\"><point name=\"center\" x=\"%.9f\" y=\"%.9f\" z=\"%.9f\"/><float name=\"radius\" value=\"%.9f\"/>"
                            + "<ref id=\"ball\"/></shape>%n",
                    s[0],
                    s[1],
                    s[2],
                    s[3]);
        }
        out.println("</scene>");
    }

    private void povray(PrintStream out) {
        // The same right-handed axes: POV-Ray's are left-handed, so its "right" vector is turned round. angle is that
        // of the width.
        out.println(
                """
                #version 3.7; global_settings { assumed_gamma 1.0 }
                camera { perspective location <2.1, 1.3, 1.7> sky z up z right -4/3*x angle 30 look_at <0, 0, 0> }
                background { rgb <0.08, 0.22, 0.36> }
                light_source { <4, 3, 2> rgb 1 area_light <0.6, 0, 0>, <0, 0.6, 0>, 4, 4 jitter circular orient }
                #declare Ball = texture { pigment { rgb <1, 0.9, 0.45> } finish { ambient 0.1 diffuse 0.9 } }
                polygon { 5, <12, 12, -0.5>, <-12, 12, -0.5>, <-12, -12, -0.5>, <12, -12, -0.5>, <12, 12, -0.5>
                  pigment { rgb <1, 0.75, 0.33> } finish { ambient 0.1 diffuse 0.9 } }""");
        for (double[] s : balls) {
            out.printf(Locale.ROOT, "sphere { <%.9f, %.9f, %.9f>, %.9f texture { Ball } }%n", s[0], s[1], s[2], s[3]);
        }
    }
}
