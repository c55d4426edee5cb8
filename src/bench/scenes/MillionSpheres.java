import java.io.PrintStream;
import java.util.Random;

/**
 * Writes a scene of N spheres over a floor: java src/bench/scenes/MillionSpheres.java 1000000 > million.json; with physical light and a sky by
 * java src/bench/scenes/MillionSpheres.java 1000000 physical > million.json
 */
public final class MillionSpheres {
    private MillionSpheres() {}

    public static void main(String[] arguments) {
        int n = Integer.parseInt(arguments[0]);
        boolean physical = arguments.length > 1 && arguments[1].equals("physical");
        Random random = new Random(1);
        PrintStream out = new PrintStream(new java.io.BufferedOutputStream(System.out, 1 << 20), false);
        out.println("{ \"name\": \"Many spheres\", \"image\": { \"width\": 800, \"height\": 450 },");
        out.println("  \"camera\": { \"type\": \"perspective\", \"eye\": [0, 40, -90], \"lookAt\": [0, 8, 0],"
                + " \"up\": [0, 1, 0], \"fieldOfView\": 40 },");
        out.println(
                physical
                        ? "  \"shading\": { \"model\": \"physical\", \"background\": \"#a9bfd4\" },"
                        : "  \"shading\": { \"model\": \"classic\", \"background\": \"#a9bfd4\" },");
        out.println("  \"materials\": { \"a\": { \"type\": \"matte\", \"color\": \"#d8a03c\" },"
                + " \"b\": { \"type\": \"matte\", \"color\": \"#3c78d8\" },"
                + " \"c\": { \"type\": \"matte\", \"color\": \"#e0e0d8\" } },");
        out.println("  \"lights\": [ { \"type\": \"sphere\", \"center\": [60, 120, -80], \"radius\": 8, "
                + "\"color\": \"#ffffff\"" + (physical ? ", \"radiance\": [150, 150, 150]" : "") + " } ],");
        out.println("  \"objects\": [");
        out.println("    { \"type\": \"rectangle\", \"material\": \"c\", \"corners\": [[-200, 0, -200], [-200, 0, 200],"
                + " [200, 0, 200], [200, 0, -200]] }");
        for (int i = 0; i < n; i++) {
            double angle = 40 * random.nextDouble();
            double radius = 30 * (1 - angle / 60) + 4 * random.nextGaussian();
            out.printf(
                    java.util.Locale.ROOT,
                    "    , { \"type\": \"sphere\", \"center\": [%.5f, %.5f, %.5f], \"radius\": %.4f, \"material\": \"%s\" }%n",
                    radius * Math.cos(angle),
                    0.5 + 0.8 * angle + random.nextGaussian(),
                    radius * Math.sin(angle),
                    0.05 + 0.15 * random.nextDouble(),
                    i % 2 == 0 ? "a" : "b");
        }
        out.println("  ] }");
        out.flush();
    }
}
