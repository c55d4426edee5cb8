package enlightenment.scene;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.ServiceLoader;

/** The methods from outside, looked for when this class is first needed: a start without them must not pay for the search. */
final class Extensions {
    /** By their words: the order in which services are found is anybody's. */
    static final List<Method> FOUND = found();

    private Extensions() {}

    private static List<Method> found() {
        List<Method> all = new ArrayList<>(BuiltInMethod.ALL);
        List<Method> sorted = new ArrayList<>();
        ServiceLoader.load(MethodExtension.class).forEach(sorted::add);
        sorted.sort(Comparator.comparing(Method::word));
        for (Method method : sorted) {
            all.forEach(other -> requireDistinct(method, other));
            all.add(method);
        }
        return List.copyOf(sorted);
    }

    /** Whoever put these two together must hear of it; to take one of them would be silent. */
    static void requireDistinct(Method method, Method other) {
        if (method.word().equals(other.word())) {
            throw new IllegalStateException("there are two methods called " + method.word() + ": "
                    + method.getClass().getName() + " and " + other.getClass().getName());
        }
        for (MethodSetting mine : method.settings()) {
            for (MethodSetting theirs : other.settings()) {
                if (mine.key().equals(theirs.key()) && !mine.equals(theirs)) {
                    throw new IllegalStateException("the methods " + method.word() + " and " + other.word()
                            + " mean different things by the setting " + mine.key());
                }
            }
        }
    }
}
