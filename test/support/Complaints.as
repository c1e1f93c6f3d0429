package support
{
    import org.flexunit.asserts.assertTrue;

    /** Counts what is wrong, case by case, so that a test that fails says of which colliders and how often. */
    public final class Complaints
    {
        private var _names:Array = [];
        private var _counts:Object = {};
        private var _firsts:Object = {};

        /** Nothing is wrong yet. */
        public function Complaints()
        {
        }

        /** Notes that something is wrong; only the first of a name is told in full. */
        public function add(name:String, what:String):void
        {
            if (!_counts.hasOwnProperty(name))
            {
                _names.push(name);
                _counts[name] = 0;
                _firsts[name] = what;
            }
            _counts[name]++;
        }

        /** Notes it if it is wrong. */
        public function addIf(isWrong:Boolean, name:String, what:String):void
        {
            if (isWrong)
            {
                add(name, what);
            }
        }

        /** Fails if anything is wrong. */
        public function assertNone():void
        {
            var lines:Array = [];
            for each (var name:String in _names)
            {
                lines.push(_counts[name] + " of " + name + ", the first: " + _firsts[name]);
            }
            assertTrue(lines.join("\n"), lines.length == 0);
        }
    }
}
