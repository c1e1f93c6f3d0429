package support
{
    import flash.utils.getQualifiedClassName;
    import org.flexunit.runner.IDescription;
    import org.flexunit.runner.Request;
    import org.flexunit.runner.manipulation.filters.DynamicFilter;

    /**
     * Picks tests by name: <code>BoxBox</code> takes the classes whose name contains it, <code>BoxBoxTest.touching</code>
     * the tests of such classes whose name contains the rest, nothing takes all.
     */
    public class TestFilter
    {
        /** What was asked for. */
        public var pattern:String;

        private var _classPattern:String;
        private var _method:String;

        public function TestFilter(pattern:String)
        {
            this.pattern = pattern || "";
            var parts:Array = this.pattern.split(/[.#]/);
            _classPattern = parts[0];
            _method = parts.length > 1 ? parts[1] : "";
        }

        /** The classes among these that the pattern names. */
        public function classesOf(classes:Array):Array
        {
            return classes.filter(matches);
        }

        /** Whether the pattern names a test among those of a request. */
        public function doesPick(request:Request):Boolean
        {
            return shouldRun(request.iRunner.description);
        }

        /** The request without the methods that the pattern leaves out. */
        public function narrow(request:Request):Request
        {
            return _method == "" ? request : request.filterWith(new DynamicFilter(shouldRun, describe));
        }

        private function matches(testClass:Class, index:int, classes:Array):Boolean
        {
            var name:String = getQualifiedClassName(testClass).split("::").pop();
            return name.indexOf(_classPattern) >= 0;
        }

        private function shouldRun(description:IDescription):Boolean
        {
            if (!description.isTest)
            {
                for each (var child:IDescription in description.children)
                {
                    if (shouldRun(child))
                    {
                        return true;
                    }
                }
                return false;
            }
            return description.displayName.split(".").pop().indexOf(_method) >= 0;
        }

        private function describe(description:IDescription):String
        {
            return "tests named " + _method;
        }
    }
}
