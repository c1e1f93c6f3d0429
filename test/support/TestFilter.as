package support
{
    import flash.utils.getQualifiedClassName;
    import org.flexunit.runner.IDescription;
    import org.flexunit.runner.Request;
    import org.flexunit.runner.manipulation.filters.DynamicFilter;

    /**
     * Picks tests by name: <code>BoxBox</code> takes the classes whose name contains it, <code>BoxBoxTest.touching</code>
     * the tests of such classes whose name contains the rest, nothing takes all but those that run elsewhere.
     */
    public class TestFilter
    {
        /** What was asked for. */
        public var pattern:String;

        private var _classPattern:String;
        private var _method:String;
        private var _elsewhere:Object = {};
        private var _leavesOut:Boolean;

        /**
         * @param pattern a part of names
         * @param elsewhere classes and tests that another machine runs, separated by commas; a pattern takes these too
         */
        public function TestFilter(pattern:String, elsewhere:String = null)
        {
            this.pattern = pattern || "";
            _leavesOut = this.pattern == "" && elsewhere != null && elsewhere != "";
            for each (var name:String in _leavesOut ? elsewhere.split(",") : [])
            {
                _elsewhere[name] = true;
            }
            var parts:Array = this.pattern.split(/[.#]/);
            _classPattern = parts[0];
            _method = parts.length > 1 ? parts[1] : "";
        }

        /** The classes among these that the pattern names. */
        public function classesOf(classes:Array):Array
        {
            return classes.filter(matches);
        }

        /** Whether tests are left out that another machine runs. */
        public function get leavesOut():Boolean
        {
            return _leavesOut;
        }

        /** Whether the pattern names a test among those of a request. */
        public function doesPick(request:Request):Boolean
        {
            // a request that is asked for its description has all its tests in it for good
            return pattern == "" || shouldRun(request.iRunner.description);
        }

        /** The request without the methods that the pattern leaves out. */
        public function narrow(request:Request):Request
        {
            return _method == "" && !_leavesOut ? request : request.filterWith(new DynamicFilter(shouldRun, describe));
        }

        private function matches(testClass:Class, index:int, classes:Array):Boolean
        {
            var name:String = getQualifiedClassName(testClass).replace("::", ".");
            return name.split(".").pop().indexOf(_classPattern) >= 0 && !_elsewhere[name];
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
            var name:String = description.displayName.replace("::", ".");
            return name.split(".").pop().indexOf(_method) >= 0 && !_elsewhere[name];
        }

        private function describe(description:IDescription):String
        {
            return _method == "" ? "tests that run here" : "tests named " + _method;
        }
    }
}
