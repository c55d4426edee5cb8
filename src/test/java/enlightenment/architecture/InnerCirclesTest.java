package enlightenment.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/**
 * Inside a package few classes use each other in a circle: what cannot be read alone must be small. A sealed family counts as one class,
 * since each member names the family and the family names its members.
 */
class InnerCirclesTest {
    private static final int MOST = 5;

    /** Larger circles that are debts, by package: the number of classes. It may fall, and this table falls with it. */
    private static final Map<String, Integer> DEBTS = Map.of(
            "enlightenment.primitive", 10,
            "enlightenment.scene", 8,
            "enlightenment.store", 9);

    /** By package and class: the classes of that package that it uses. */
    private final Map<String, Map<String, Set<String>>> uses = new TreeMap<>();

    /** By class: the head of its sealed family. */
    private final Map<String, String> families = new TreeMap<>();

    @Test
    void noMoreThanAFewClassesOfAPackageUseEachOtherInACircle() {
        List<JavaClass> classes = new ArrayList<>();
        new ClassFileImporter()
                .withImportOption(new ImportOption.DoNotIncludeTests())
                .importPackages("enlightenment")
                .forEach(classes::add);
        classes.forEach(this::joinFamily);
        classes.forEach(this::addUses);
        Map<String, Integer> found = new TreeMap<>();
        Map<String, String> members = new TreeMap<>();
        uses.forEach((name, graph) -> {
            for (Set<String> circle : circles(graph)) {
                if (circle.size() > MOST) {
                    found.merge(name, circle.size(), Math::max);
                    members.merge(name, circle.toString(), String::concat);
                }
            }
        });
        assertEquals(new TreeMap<>(DEBTS), found, members.toString());
    }

    private void joinFamily(JavaClass c) {
        Class<?> type = c.reflect();
        if (type.isSealed()) {
            for (Class<?> member : type.getPermittedSubclasses()) {
                families.put(outermost(member.getName()), outermost(type.getName()));
            }
        }
    }

    private void addUses(JavaClass c) {
        Map<String, Set<String>> graph = uses.computeIfAbsent(c.getPackageName(), k -> new TreeMap<>());
        Set<String> used = graph.computeIfAbsent(node(c), k -> new TreeSet<>());
        for (Dependency d : c.getDirectDependenciesFromSelf()) {
            JavaClass target = d.getTargetClass().getBaseComponentType();
            if (target.getPackageName().equals(c.getPackageName())) {
                used.add(node(target));
            }
        }
        used.remove(node(c));
    }

    private String node(JavaClass c) {
        String node = outermost(c.getName());
        while (families.containsKey(node) && !families.get(node).equals(node)) {
            node = families.get(node);
        }
        return node.substring(node.lastIndexOf('.') + 1);
    }

    private static String outermost(String name) {
        int nested = name.indexOf('$');
        return nested < 0 ? name : name.substring(0, nested);
    }

    /** The sets of classes of which each reaches each. */
    private static List<Set<String>> circles(Map<String, Set<String>> graph) {
        Map<String, Set<String>> reached = new TreeMap<>();
        graph.keySet().forEach(from -> reached.put(from, reachedFrom(from, graph)));
        List<Set<String>> circles = new ArrayList<>();
        Set<String> placed = new TreeSet<>();
        for (String a : graph.keySet()) {
            if (placed.contains(a)) {
                continue;
            }
            Set<String> circle = new TreeSet<>(Set.of(a));
            for (String b : reached.get(a)) {
                if (reached.getOrDefault(b, Set.of()).contains(a)) {
                    circle.add(b);
                }
            }
            placed.addAll(circle);
            circles.add(circle);
        }
        return circles;
    }

    private static Set<String> reachedFrom(String from, Map<String, Set<String>> graph) {
        Set<String> reached = new TreeSet<>();
        Deque<String> left = new ArrayDeque<>(List.of(from));
        while (!left.isEmpty()) {
            for (String next : graph.getOrDefault(left.pop(), Set.of())) {
                if (reached.add(next)) {
                    left.push(next);
                }
            }
        }
        return reached;
    }
}
