package enlightenment.cli;

import enlightenment.scene.Method;
import java.util.Iterator;

/** The names of the methods, for help and completion. */
final class MethodNames implements Iterable<String> {
    @Override
    public Iterator<String> iterator() {
        return Method.words().iterator();
    }
}
