package soak
{
    /** What has happened in a soak: numbers by name, of which none may stay 0. */
    public final class SoakCounts
    {
        private static const NAMED:int = 5;

        private var _names:Array = [];
        private var _counts:Object = {};

        /**
         * @param names of all that is counted, in the order in which it is printed
         */
        public function SoakCounts(names:Array)
        {
            for each (var name:String in names)
            {
                _names.push(name);
                _counts[name] = 0;
            }
        }

        /**
         * Counts something.
         *
         * @throws ArgumentError if it has no name here
         */
        public function add(name:String, times:int = 1):void
        {
            if (!_counts.hasOwnProperty(name))
            {
                throw new ArgumentError("nothing called \"" + name + "\" is counted");
            }
            _counts[name] += times;
        }

        /** How many of it there were. */
        public function of(name:String):int
        {
            return _counts[name];
        }

        /** The names of what never happened. */
        public function get missing():Array
        {
            return _names.filter(function(name:String, index:int, all:Array):Boolean
                {
                    return _counts[name] == 0;
                });
        }

        /** How many kinds there are, and the rarest. */
        public function toString():String
        {
            var rarest:Array = _names.concat().sort(function(a:String, b:String):Number
                {
                    return _counts[a] - _counts[b];
                }).slice(0, NAMED);
            return "  " + _names.length + " kinds of events, the rarest: " + rarest.map(function(name:String, index:int, all:Array):String
                {
                    return name + " " + _counts[name];
                }).join(", ");
        }
    }
}
