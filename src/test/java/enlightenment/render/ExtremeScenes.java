package enlightenment.render;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Texts of scenes at and beyond the edge of what numbers hold: all primitives, materials, cameras and lights, with sizes and
 * places between 1e-323 and 1.7e308. About half of them are scenes; the other half is to be refused.
 */
final class ExtremeScenes {
    private static final String[] CORNERS = {"lowerLeft", "upperLeft", "upperRight", "lowerRight"};

    private static final String[] PALETTE = {
        "0",
        "0",
        "-0.0",
        "1",
        "-1",
        "0.5",
        "1.7e308",
        "-1.7e308",
        "4.9e-324",
        "-4.9e-324",
        "1e-320",
        "2.2e-308",
        "1e154",
        "-1e154",
        "1e-154",
        "1e-162",
        "1e100",
        "1e-100",
        "3e-17",
        "1e17",
        "1e300",
        "1e-300",
        "8.9e307",
        "1e-30"
    };

    private final Random random;
    private int mode;
    private int scale;
    private List<BigDecimal[]> places;

    ExtremeScenes(long seed) {
        random = new Random(seed);
    }

    /** The next text. */
    String next() {
        mode = random.nextInt(5);
        scale = random.nextInt(630) - 323;
        places = new ArrayList<>();
        List<String> objects = new ArrayList<>();
        List<String> lights = new ArrayList<>();
        for (int i = random.nextInt(4); i >= 0; i--) {
            objects.add(object());
        }
        for (int i = random.nextInt(3); i > 0; i--) {
            lights.add(light());
        }
        return "{ \"image\": { \"width\": 6, \"height\": 5 },\n \"textures\": { \"tiles\": { \"type\": \"checker\", \"colors\": [\"#ff0000\", \"#00ff00\"], \"scale\": 7 } },"
                + "\n \"camera\": " + camera() + ",\n \"lights\": " + lights
                + ",\n \"objects\": " + String.join(",\n", objects.toString()) + " }";
    }

    private <T> T one(List<T> of) {
        return of.get(random.nextInt(of.size()));
    }

    private BigDecimal number() {
        BigDecimal digits = BigDecimal.valueOf(random.nextInt(2001) - 1000, 3);
        return switch (mode) {
            case 0 -> digits.scaleByPowerOfTen(random.nextInt(630) - 323);
            case 1 -> digits.scaleByPowerOfTen(scale);
            case 2 -> new BigDecimal(PALETTE[random.nextInt(PALETTE.length)]);
            case 3 -> BigDecimal.ONE.add(digits.scaleByPowerOfTen(-random.nextInt(40)));
            default ->
                random.nextInt(6) == 0
                        ? new BigDecimal(PALETTE[random.nextInt(PALETTE.length)])
                        : digits.scaleByPowerOfTen(scale);
        };
    }

    private String text(BigDecimal v) {
        // Beyond the range of doubles is refused at once, which would test nothing else.
        double d = v.doubleValue();
        return Double.isInfinite(d) || d == 0 ? Double.isInfinite(d) ? "1.7e308" : "0" : v.toString();
    }

    private String size() {
        BigDecimal v = number().abs();
        return text(v.doubleValue() == 0 ? new BigDecimal("1e-320") : v);
    }

    private BigDecimal[] place() {
        BigDecimal[] p = {number(), number(), number()};
        if (!places.isEmpty() && random.nextInt(3) == 0) {
            BigDecimal[] q = one(places);
            for (int k = 0; k < 3; k++) {
                p[k] = random.nextInt(3) == 0 ? p[k] : q[k];
            }
        }
        places.add(p);
        return p;
    }

    private String point() {
        return point(place());
    }

    private String point(BigDecimal[] p) {
        return "[" + text(p[0]) + ", " + text(p[1]) + ", " + text(p[2]) + "]";
    }

    private String direction() {
        return random.nextInt(3) == 0 ? one(List.of("[0, 1, 0]", "[0, -0.0, 1]", "[1, 1, 0]")) : point();
    }

    private String[] corners() {
        BigDecimal[] a = place();
        BigDecimal[] b = place();
        BigDecimal[] d = place();
        BigDecimal[] c = new BigDecimal[3];
        for (int k = 0; k < 3; k++) {
            c[k] = b[k].add(d[k]).subtract(a[k], new MathContext(800));
        }
        return new String[] {point(a), point(b), point(c), point(d)};
    }

    private String object() {
        String shape =
                switch (random.nextInt(9)) {
                    case 0 -> "\"type\": \"sphere\", \"center\": " + point() + ", \"radius\": " + size();
                    case 1 -> "\"type\": \"rectangle\", \"corners\": [" + String.join(", ", corners()) + "]";
                    case 2 ->
                        "\"type\": \"disk\", \"center\": " + point() + ", \"normal\": " + direction() + ", \"radius\": "
                                + size();
                    case 3 ->
                        "\"type\": \"cylinder\", \"base\": " + point() + ", \"top\": " + point() + ", \"radius\": "
                                + size() + ", \"capped\": " + random.nextBoolean();
                    case 4 ->
                        "\"type\": \"cone\", \"base\": " + point() + ", \"apex\": " + point() + ", \"radius\": "
                                + size() + (random.nextBoolean() ? "" : ", \"topRadius\": " + size()) + ", \"capped\": "
                                + random.nextBoolean();
                    case 5 ->
                        "\"type\": \"cube\", \"center\": " + point() + ", \"radius\": " + size()
                                + (random.nextBoolean() ? "" : ", \"rotation\": " + point());
                    case 6 -> box();
                    case 7 -> torus();
                    default ->
                        "\"type\": \"triangle\", \"vertices\": [" + point() + ", " + point() + ", " + point() + "]";
                };
        return "{ " + shape + ", \"material\": " + material() + " }";
    }

    private String box() {
        BigDecimal[] a = place();
        BigDecimal[] b = place();
        BigDecimal[] min = new BigDecimal[3];
        BigDecimal[] max = new BigDecimal[3];
        for (int k = 0; k < 3; k++) {
            min[k] = a[k].min(b[k]);
            max[k] = a[k].compareTo(b[k]) == 0 ? a[k].add(BigDecimal.ONE) : a[k].max(b[k]);
        }
        return "\"type\": \"box\", \"min\": " + point(min) + ", \"max\": " + point(max);
    }

    private String torus() {
        BigDecimal a = new BigDecimal(size());
        BigDecimal b = new BigDecimal(size());
        return "\"type\": \"torus\", \"center\": " + point() + ", \"axis\": " + direction() + ", \"majorRadius\": "
                + text(a.max(b)) + ", \"minorRadius\": " + text(a.min(b));
    }

    private String material() {
        String color = one(List.of("\"#8040c0\"", "\"#ffffff\"", "{ \"texture\": \"tiles\" }"));
        return switch (random.nextInt(4)) {
            case 0 -> "{ \"type\": \"mirror\", \"color\": " + color + " }";
            case 1 ->
                "{ \"type\": \"glass\", \"color\": " + color + ", \"indexOfRefraction\": "
                        + one(List.of("1", "1.5", "0.7", "1e-320", "1.7e308", "1.0000000000000002"))
                        + ", \"transparency\": "
                        + one(List.of("1", "0.5", "0")) + " }";
            default -> "{ \"type\": \"matte\", \"color\": " + color + " }";
        };
    }

    private String light() {
        String shape =
                switch (random.nextInt(3)) {
                    case 0 -> "\"type\": \"sphere\", \"center\": " + point() + ", \"radius\": " + size();
                    case 1 -> "\"type\": \"rectangle\", \"corners\": [" + String.join(", ", corners()) + "]";
                    default -> "\"type\": \"point\", \"position\": " + point();
                };
        return "{ " + shape + ", \"color\": \"#fff0e0\" }";
    }

    private String camera() {
        String lookAt = point(random.nextInt(4) == 0 ? place() : one(places));
        String views = ", \"eye\": " + point() + ", \"lookAt\": " + lookAt + ", \"up\": " + direction();
        return switch (random.nextInt(4)) {
            case 0 -> {
                String[] c = corners();
                StringBuilder s = new StringBuilder("{ \"type\": \"window\", \"eye\": " + point());
                for (int i = 0; i < 4; i++) {
                    s.append(", \"").append(CORNERS[i]).append("\": ").append(c[i]);
                }
                yield s + " }";
            }
            case 1 ->
                "{ \"type\": \"perspective\"" + views + ", \"fieldOfView\": "
                        + one(List.of("40", "1e-10", "179.999", "1e-320", "179.99999999999997")) + " }";
            case 2 -> "{ \"type\": \"orthographic\"" + views + ", \"height\": " + size() + " }";
            default -> "{ \"type\": \"isometric\", \"lookAt\": " + lookAt + ", \"height\": " + size() + " }";
        };
    }
}
