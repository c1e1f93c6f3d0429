package support
{
    import flash.utils.getQualifiedClassName;
    import org.flexunit.runner.IDescription;
    import org.flexunit.runner.Request;
    import org.flexunit.runner.manipulation.filters.DynamicFilter;

    /**
     * Picks the tests that the build was asked for, or all but those that run elsewhere.
     */
    public class TestFilter
    {
        private var _picked:Object;
        private var _elsewhere:Object;

        // Of so many parts of the classes, the one that is run, counted from 0 on.
        private var _part:int = 0;
        private var _parts:int = 1;

        /**
         * @param picked classes and tests of classes, by qualified names with commas between; nothing for all
         * @param elsewhere classes and tests that another machine runs, in the same form; it does not matter if something is picked
         * @param part the part of the classes that is run: "2/3" is the second of three parts; nothing for all
         */
        public function TestFilter(picked:String, elsewhere:String = null, part:String = null)
        {
            if (part)
            {
                _part = int(part.split("/")[0]) - 1;
                _parts = int(part.split("/")[1]);
            }
            _picked = tableOf(picked);
            _elsewhere = _picked == null ? tableOf(elsewhere) : null;
        }

        /** The classes among these of which something is run. */
        public function classesOf(classes:Array):Array
        {
            return classes.filter(hasRun).filter(isInPart);
        }

        /** Whether tests are left out that another machine runs. */
        public function get leavesOut():Boolean
        {
            return _elsewhere != null;
        }

        /** The request without the tests that are not run. */
        public function narrow(request:Request):Request
        {
            return _picked == null && _elsewhere == null ? request : request.filterWith(new DynamicFilter(shouldRun, describe));
        }

        private static function tableOf(names:String):Object
        {
            if (names == null || names == "")
            {
                return null;
            }
            var table:Object = {};
            for each (var name:String in names.split(","))
            {
                table[name] = true;
            }
            return table;
        }

        private function hasRun(testClass:Class, index:int, classes:Array):Boolean
        {
            var className:String = getQualifiedClassName(testClass).replace("::", ".");
            if (_picked == null)
            {
                return _elsewhere == null || !_elsewhere[className];
            }
            for (var name:String in _picked)
            {
                if (name == className || name.indexOf(className + ".") == 0)
                {
                    return true;
                }
            }
            return false;
        }

        private function isInPart(testClass:Class, index:int, classes:Array):Boolean
        {
            return index % _parts == _part;
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
            var className:String = name.slice(0, name.lastIndexOf("."));
            return _picked == null ? !_elsewhere[name] : _picked[className] || _picked[name];
        }

        private function describe(description:IDescription):String
        {
            return _picked == null ? "tests that run here" : "tests that were picked";
        }
    }
}
