import java.io.PrintStream;
import java.util.Locale;
import java.util.Random;

/** Writes a room with N lamps, spheres or rectangles: java src/bench/scenes/ManyLamps.java 20000 sphere > lamps.json */
public final class ManyLamps {
    private ManyLamps() {}

    public static void main(String[] arguments) {
        int n = Integer.parseInt(arguments[0]);
        boolean spheres = arguments[1].equals("sphere");
        Random random = new Random(1);
        PrintStream out = new PrintStream(new java.io.BufferedOutputStream(System.out, 1 << 20), false);
        out.println("{ \"name\": \"Many lamps\", \"image\": { \"width\": 400, \"height\": 300 },");
        out.println("  \"camera\": { \"type\": \"perspective\", \"eye\": [0, 2, -7], \"lookAt\": [0, 2, 0],"
                + " \"up\": [0, 1, 0], \"fieldOfView\": 50 },");
        out.println("  \"shading\": { \"model\": \"physical\", \"background\": [0, 0, 0] },");
        out.println("  \"materials\": { \"a\": { \"type\": \"matte\", \"color\": [0.7, 0.7, 0.7] } },");
        out.println("  \"objects\": [");
        String wall = "    { \"type\": \"rectangle\", \"material\": \"a\", \"corners\": %s },%n";
        out.printf(wall, "[[-5, 0, -8], [-5, 0, 5], [5, 0, 5], [5, 0, -8]]");
        out.printf(wall, "[[-5, 0, 5], [-5, 5, 5], [5, 5, 5], [5, 0, 5]]");
        out.printf(wall, "[[-5, 0, -8], [-5, 5, -8], [-5, 5, 5], [-5, 0, 5]]");
        out.println("    { \"type\": \"sphere\", \"center\": [0, 1, 0], \"radius\": 1, \"material\": \"a\" } ],");
        out.println("  \"lights\": [");
        double size = 0.1 / Math.sqrt(n / 1000.0);
        for (int i = 0; i < n; i++) {
            double x = 9 * random.nextDouble() - 4.5;
            double y = 2.5 + 2 * random.nextDouble();
            double z = 9 * random.nextDouble() - 4.5;
            double radiance = 0.5 + random.nextDouble();
            String form = spheres
                    ? String.format(
                            Locale.ROOT,
                            "\"type\": \"sphere\", \"center\": [%.5f, %.5f, %.5f], \"radius\": %.5f",
                            x,
                            y,
                            z,
                            size)
                    : String.format(
                            Locale.ROOT,
                            "\"type\": \"rectangle\", \"corners\": [[%.5f, %.5f, %.5f], [%.5f, %.5f, %.5f],"
                                    + " [%.5f, %.5f, %.5f], [%.5f, %.5f, %.5f]]",
                            x,
                            y,
                            z,
                            x,
                            y,
                            z + size,
                            x + size,
                            y,
                            z + size,
                            x + size,
                            y,
                            z);
            out.printf(
                    Locale.ROOT,
                    "    { %s, \"color\": \"#ffffff\", \"radiance\": [%.4f, %.4f, %.4f] }%s%n",
                    form,
                    radiance,
                    radiance,
                    radiance,
                    i + 1 < n ? "," : "");
        }
        out.println("  ] }");
        out.flush();
    }
}
