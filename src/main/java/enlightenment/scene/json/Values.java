package enlightenment.scene.json;

import enlightenment.color.DisplayRgb;
import enlightenment.math.Point;
import enlightenment.math.Vec3;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.Arrays;
import java.util.List;

/**
 * Nodes as values of the wanted type. Where a node is of another type, the problem is recorded and a stand-in returned
 * (NaN, null, 0) that nobody may build on: see {@link Problems#failures()}.
 */
final class Values {
    private static final BigInteger LEAST = BigInteger.valueOf(Long.MIN_VALUE);
    private static final BigInteger MOST = BigInteger.valueOf(Long.MAX_VALUE);

    final Problems problems;

    Values(Problems problems) {
        this.problems = problems;
    }

    private void expected(Node node, String what) {
        problems.at(node, "must be " + what + ", not " + node.describe());
    }

    private Node.Num num(Node node, String what) {
        if (!(node instanceof Node.Num)) {
            expected(node, what);
            return null;
        }
        if (((Node.Num) node).bad) {
            problems.fail();
            return null;
        }
        return (Node.Num) node;
    }

    double number(Node node) {
        Node.Num n = num(node, "a number");
        return n == null ? Double.NaN : Double.parseDouble(n.text);
    }

    BigDecimal decimal(Node node) {
        Node.Num n = num(node, "a number");
        return n == null ? null : new BigDecimal(n.text);
    }

    /** A whole number between lo and hi, both included. */
    long whole(Node node, long lo, long hi) {
        boolean anyLong = lo == Long.MIN_VALUE && hi == Long.MAX_VALUE;
        String what = anyLong ? "a whole number of 64 bits" : "a whole number in " + lo + ".." + hi;
        Node.Num n = num(node, what);
        if (n == null) {
            return 0;
        }
        BigDecimal d = new BigDecimal(n.text);
        if (d.stripTrailingZeros().scale() <= 0) {
            BigInteger i = d.toBigInteger();
            if (i.compareTo(LEAST) >= 0 && i.compareTo(MOST) <= 0 && i.longValue() >= lo && i.longValue() <= hi) {
                return i.longValue();
            }
        }
        expected(node, what);
        return 0;
    }

    String string(Node node) {
        if (node instanceof Node.Str) {
            return ((Node.Str) node).text;
        }
        expected(node, "a string");
        return null;
    }

    boolean truth(Node node) {
        if (node instanceof Node.Word && ((Node.Word) node).value != null) {
            return ((Node.Word) node).value;
        }
        expected(node, "true or false");
        return false;
    }

    /** One of a few words; null where it is none of them. */
    String word(Node node, String what, String... words) {
        if (!(node instanceof Node.Str)) {
            expected(node, what + ": " + list(words));
            return null;
        }
        String found = ((Node.Str) node).text;
        List<String> known = Arrays.asList(words);
        if (known.contains(found)) {
            return found;
        }
        problems.at(
                node,
                "must be " + what + ": " + list(words) + ", not " + Node.quote(found)
                        + problems.suggestion(found, known));
        return null;
    }

    /** The words in quotes with commas between. */
    static String list(String... words) {
        StringBuilder s = new StringBuilder();
        for (String word : words) {
            s.append(s.length() == 0 ? "\"" : ", \"").append(word).append('"');
        }
        return s.toString();
    }

    /** The node as an object, or null. */
    Node.Obj object(Node node, String what) {
        if (node instanceof Node.Obj) {
            return (Node.Obj) node;
        }
        expected(node, what);
        return null;
    }

    /** The values of an array of any length, or null. */
    List<Node> array(Node node, String what) {
        if (node instanceof Node.Arr) {
            return ((Node.Arr) node).values;
        }
        expected(node, what);
        return null;
    }

    /** The values of an array of this length, or null. */
    List<Node> array(Node node, int length, String what) {
        if (node instanceof Node.Arr && ((Node.Arr) node).values.size() == length) {
            return ((Node.Arr) node).values;
        }
        expected(node, what);
        return null;
    }

    Point point(Node node) {
        List<Node> v = array(node, 3, "a point [x, y, z]");
        if (v == null) {
            return null;
        }
        BigDecimal x = decimal(v.get(0));
        BigDecimal y = decimal(v.get(1));
        BigDecimal z = decimal(v.get(2));
        return x == null || y == null || z == null ? null : new Point(x, y, z);
    }

    /** Several points; entries may be null where they failed. Null where it is no array of that length. */
    Point[] points(Node node, int count, String what) {
        List<Node> v = array(node, count, what);
        if (v == null) {
            return null;
        }
        Point[] points = new Point[count];
        for (int i = 0; i < count; i++) {
            points[i] = point(v.get(i));
        }
        return points;
    }

    Vec3 vector(Node node, String what) {
        List<Node> v = array(node, 3, what);
        return v == null ? null : new Vec3(number(v.get(0)), number(v.get(1)), number(v.get(2)));
    }

    DisplayRgb color(Node node) {
        String what = "a colour, \"#rrggbb\" or [r, g, b] with components in 0..1";
        if (node instanceof Node.Str) {
            DisplayRgb color = hexadecimal(((Node.Str) node).text);
            if (color == null) {
                expected(node, what);
            }
            return color;
        }
        List<Node> v = array(node, 3, what);
        if (v == null) {
            return null;
        }
        double r = component(v.get(0));
        double g = component(v.get(1));
        double b = component(v.get(2));
        return r >= 0 && g >= 0 && b >= 0 ? new DisplayRgb(r, g, b) : null;
    }

    private double component(Node node) {
        double c = number(node);
        if (c >= 0 && c <= 1 || Double.isNaN(c)) {
            return c;
        }
        expected(node, "a colour component in 0..1");
        return Double.NaN;
    }

    private static DisplayRgb hexadecimal(String text) {
        if (text.length() != 7 || text.charAt(0) != '#') {
            return null;
        }
        int value = 0;
        for (int i = 1; i < 7; i++) {
            char c = text.charAt(i);
            int digit = c < 128 ? Character.digit(c, 16) : -1;
            if (digit < 0) {
                return null;
            }
            value = 16 * value + digit;
        }
        return DisplayRgb.ofBytes(value >> 16, value >> 8 & 255, value & 255);
    }
}
