package evaluation
{
    import starlogo.GreatLand;
    import starlogo.collision.CollisionSystem;
    import starlogo.fitting.Fitter;

    /** Makes the colliders and fitters that a researcher has compiled into the harness, by the names of their classes. */
    public final class OwnClasses
    {
        private static const ARGUMENT_COUNT:int = 1063;

        private var _find:Function;

        /**
         * @param find <code>(name:String):Object</code>: the class with a name, as getDefinitionByName; null if there are none
         */
        public function OwnClasses(find:Function = null)
        {
            _find = find;
        }

        /**
         * Makes a collider. Its constructor takes the GreatLand, or nothing.
         *
         * @throws ArgumentError if there is no such class, or it is not a CollisionSystem
         */
        public function collider(name:String, greatLand:GreatLand):CollisionSystem
        {
            var type:Class = typeOf("colliders", name);
            var made:CollisionSystem = (madeWith(type, [greatLand]) || madeWith(type, [])) as CollisionSystem;
            if (made == null)
            {
                throw new ArgumentError("-Dcolliders: " + name + " is not a CollisionSystem");
            }
            return made;
        }

        /**
         * Makes a fitter. Its constructor takes nothing.
         *
         * @throws ArgumentError if there is no such class, or it is not a Fitter
         */
        public function fitter(name:String):Fitter
        {
            var type:Class = typeOf("fitters", name);
            var made:Fitter = madeWith(type, []) as Fitter;
            if (made == null)
            {
                throw new ArgumentError("-Dfitters: " + name + " is not a Fitter whose constructor takes nothing");
            }
            return made;
        }

        private function typeOf(option:String, name:String):Class
        {
            var type:Class = null;
            try
            {
                type = _find == null ? null : _find(name);
            }
            catch (error:ReferenceError)
            {
                // said below
            }
            if (type == null)
            {
                throw new ArgumentError("-D" + option + ": there is no class \"" + name + "\"; -Dsources= names the folder in which it is");
            }
            return type;
        }

        // An object of a class; null if its constructor takes other arguments.
        private static function madeWith(type:Class, all:Array):Object
        {
            try
            {
                return all.length == 0 ? new type() : new type(all[0]);
            }
            catch (error:ArgumentError)
            {
                if (error.errorID != ARGUMENT_COUNT)
                {
                    throw error;
                }
            }
            return null;
        }
    }
}
