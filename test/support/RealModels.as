package support
{
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;

    /**
     * Models that nobody here made, by name: from Debian's package assimp-testmodels and, written as OBJ by
     * test/models/prepare.mjs, from npm.
     */
    public final class RealModels
    {
        // name: address, and the axis that points up in an OBJ file
        private static const FILES:Object = {
                spider: "/assimp/OBJ/spider.obj",
                wuson: "/assimp/OBJ/WusonOBJ.obj",
                box: "/assimp/OBJ/box.obj",
                duck: "/assimp/Collada/duck.dae",
                teapots2: "/assimp/Collada/teapot_instancenodes.DAE",
                sphere: "/assimp/Collada/sphere.dae",
                human: "/models/human.dae",
                bunny: "/models/bunny.obj",
                teapot: "/models/teapot.obj",
                dragon4: "/models/dragon4.obj",
                dragon3: "/models/dragon3.obj"
            };

        /** What a test that reads them has to list in its FIXTURES. */
        public static const FIXTURES:Array = addresses();

        /** Skips the test that calls it where a model is not there. */
        public static function assume():void
        {
            for each (var address:String in FILES)
            {
                Fixtures.assume(address, "the package assimp-testmodels is not installed, or test/models/prepare.mjs was not run");
            }
        }

        /** Reads one of the models. */
        public static function read(name:String):Model
        {
            var address:String = FILES[name];
            if (address.substr(-4) == ".obj")
            {
                return new ObjModel(name, Fixtures.text(address), "y");
            }
            return ColladaModel.fromBytes(name, Fixtures.bytes(address));
        }

        private static function addresses():Array
        {
            var all:Array = [];
            for each (var address:String in FILES)
            {
                all.push(address);
            }
            return all;
        }
    }
}
