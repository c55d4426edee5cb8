package enlightenment.scene.json;

import enlightenment.color.DisplayRgb;
import enlightenment.math.Point;
import enlightenment.math.Vec3;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;

/** Values as JSON that {@link JsonText} prints and the reader reads back unchanged. */
final class Tokens {
    private static final int LONGEST_PLAIN = 24;

    private Tokens() {}

    static String number(double v) {
        String text = Double.toString(v);
        boolean whole = text.endsWith(".0") && !text.equals("-0.0");
        return whole ? text.substring(0, text.length() - 2) : text;
    }

    /** A coordinate: equal as a number, not necessarily written with the same zeros. */
    static String coordinate(BigDecimal v) {
        boolean isShort = v.scale() > -LONGEST_PLAIN && v.scale() < LONGEST_PLAIN && v.precision() < LONGEST_PLAIN;
        return accepted(isShort ? v.toPlainString() : v.toString());
    }

    /** A number with the very digits that it has. */
    static String exact(BigDecimal v) {
        return accepted(v.toString());
    }

    private static String accepted(String text) {
        String problem = Numbers.problem(text);
        if (problem != null) {
            throw new IllegalArgumentException("a number of the scene cannot be written: it " + problem);
        }
        return text;
    }

    static List<Object> point(Point p) {
        return List.of(coordinate(p.x()), coordinate(p.y()), coordinate(p.z()));
    }

    static List<Object> points(Point... points) {
        List<Object> list = new ArrayList<>();
        for (Point p : points) {
            list.add(point(p));
        }
        return list;
    }

    static List<Object> vector(Vec3 v) {
        return List.of(number(v.x()), number(v.y()), number(v.z()));
    }

    /** A colour: short where it is one of 8-bit components, unless its components must be numbers. */
    static Object color(DisplayRgb c, boolean asNumbers) {
        int r = (int) Math.rint(c.r() * 255);
        int g = (int) Math.rint(c.g() * 255);
        int b = (int) Math.rint(c.b() * 255);
        if (!asNumbers && DisplayRgb.ofBytes(r, g, b).equals(c)) {
            String digits = Integer.toHexString(1 << 24 | r << 16 | g << 8 | b).substring(1);
            return "\"#" + digits + "\"";
        }
        return List.of(number(c.r()), number(c.g()), number(c.b()));
    }
}
