package client
{
    import away3d.containers.ObjectContainer3D;
    import away3d.core.base.Geometry;
    import away3d.core.base.SubMesh;
    import away3d.entities.Mesh;
    import away3d.events.LoaderEvent;
    import away3d.loaders.Loader3D;
    import away3d.loaders.parsers.DAEParser;
    import away3d.loaders.parsers.OBJParser;
    import away3d.primitives.ConeGeometry;
    import away3d.primitives.CubeGeometry;
    import away3d.primitives.CylinderGeometry;
    import away3d.primitives.SphereGeometry;
    import away3d.tools.commands.Explode;
    import away3d.tools.commands.Merge;
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import flash.net.URLRequest;
    import starlogo.GreatLand;
    import starlogo.away3d.Away3dModel;
    import starlogo.away3d.Away3dModelReader;
    import starlogo.models.ModelEvent;
    import starlogo.models.ModelLoader;

    /** The shapes of a game. Each has an object for Away3D to draw, and a collision model of exactly that object. */
    public final class Cast
    {
        // Away3D always takes y as up; these files have z up and are turned
        private static const Z_UP:Array = ["bear.obj", "dragon.dae", "tree.obj", "kelp.obj", "fortress.obj", "spaceship.obj", "fireman.dae", "person.dae"];
        private static const Y_UP:Array = ["seagull.dae"];
        // files without normals, which are shown with sharp edges
        private static const FLAT:Array = ["fortress.obj", "kelp.obj"];
        private static const FOLDER:String = "/assets/";

        /** The models that the game has loaded. */
        public var greatLand:GreatLand = new GreatLand();

        private var _land:Land;
        private var _complete:Function;
        private var _failed:Function;
        private var _drawn:Object = {};
        private var _models:Object = {};
        private var _loader:ModelLoader = new ModelLoader(greatLand);
        private var _pending:int = 0;

        /**
         * Loads the shapes.
         *
         * @param land gives the light
         * @param complete called without arguments when all are loaded
         * @param failed called with a text when one can't be loaded
         */
        public function Cast(land:Land, complete:Function, failed:Function)
        {
            _land = land;
            _complete = complete;
            _failed = failed;
            _loader.addEventListener(ModelEvent.LOADED, onModel);
            _loader.addEventListener(ErrorEvent.ERROR, function(event:ErrorEvent):void
                {
                    _failed(event.text);
                });
            greatLand.loadAllBoundingStructures = true;
            for each (var file:String in Z_UP)
            {
                loadFile(file, 90);
            }
            for each (file in Y_UP)
            {
                loadFile(file, 0);
            }
            make("sphere", new Mesh(new SphereGeometry(0.5, 24, 18), land.material(0xd9dde2)));
            make("cube", new Mesh(new CubeGeometry(1, 1, 1), land.material(0xc98f4a)));
            make("cylinder", new Mesh(new CylinderGeometry(0.5, 0.5, 1.1314, 32, 7), land.material(0x8d9bb0)));
            make("turtle", turtle());
        }

        /** A new object of a shape. */
        public function draw(shape:String):Mesh
        {
            var first:Mesh = _drawn[shape];
            var made:Mesh = new Mesh(first.geometry, first.material);
            for (var i:int = 0; i < first.subMeshes.length; i++)
            {
                made.subMeshes[i].material = first.subMeshes[i].material;
            }
            return made;
        }

        /** The model of the objects that draw() makes. */
        public function model(shape:String):Away3dModel
        {
            return _models[shape];
        }

        private function loadFile(file:String, turn:Number):void
        {
            var shape:String = file.slice(0, -4);
            var loader:Loader3D = new Loader3D(false);
            loader.addEventListener(LoaderEvent.RESOURCE_COMPLETE, function(event:Event):void
                {
                    loader.rotationX = turn;
                    if (FLAT.indexOf(file) >= 0)
                    {
                        new Explode().applyToContainer(loader, false);
                    }
                    _pending--;
                    make(shape, loader);
                });
            loader.addEventListener(LoaderEvent.LOAD_ERROR, function(event:LoaderEvent):void
                {
                    _failed("can't load " + event.url + ": " + event.message);
                });
            _pending++;
            loader.load(new URLRequest(FOLDER + file), null, null, file.slice(-4) == ".dae" ? new DAEParser() : new OBJParser());
        }

        // Joins a shape's meshes into one mesh, with a part for each material. Away3D takes time for each moving mesh, and more for each if
        // there are many.
        private function make(shape:String, part:ObjectContainer3D):void
        {
            var whole:ObjectContainer3D = new ObjectContainer3D();
            whole.addChild(part);
            var drawn:Mesh = new Mesh(new Geometry());
            new Merge(true).applyToContainer(drawn, whole);
            _land.light(drawn.material);
            for each (var piece:SubMesh in drawn.subMeshes)
            {
                _land.light(piece.material);
            }
            _drawn[shape] = drawn;
            _pending++;
            _loader.loadFrom(new Away3dModelReader(shape, whole));
        }

        private function onModel(event:ModelEvent):void
        {
            _models[event.model.name] = event.model;
            _pending--;
            if (_pending == 0)
            {
                _complete();
            }
        }

        private function turtle():ObjectContainer3D
        {
            var root:ObjectContainer3D = new ObjectContainer3D();
            var skin:uint = 0x9cb84a;
            add(root, new SphereGeometry(1, 16, 12), 0x3f7d3a, 0, 0.42, 0, 0.8, 0.5, 0.65);
            add(root, new CylinderGeometry(1, 1, 1, 18), 0xd8c98a, 0, 0.34, 0, 0.78, 0.14, 0.63);
            add(root, new SphereGeometry(1, 12, 9), skin, 0.98, 0.55, 0, 0.27, 0.24, 0.22);
            add(root, new SphereGeometry(1, 8, 6), 0x1d1a19, 1.16, 0.64, 0.12, 0.05, 0.05, 0.05);
            add(root, new SphereGeometry(1, 8, 6), 0x1d1a19, 1.16, 0.64, -0.12, 0.05, 0.05, 0.05);
            add(root, new ConeGeometry(1, 1, 8), skin, -0.86, 0.3, 0, 0.12, 0.36, 0.12).rotationZ = 75;
            for each (var leg:Array in [[0.5, 0.48], [0.5, -0.48], [-0.45, 0.48], [-0.45, -0.48]])
            {
                add(root, new SphereGeometry(1, 10, 8), skin, leg[0], 0.17, leg[1], 0.22, 0.17, 0.2);
            }
            return root;
        }

        private function add(root:ObjectContainer3D, geometry:Geometry, color:uint, x:Number, y:Number, z:Number, scaleX:Number, scaleY:Number,
                scaleZ:Number):Mesh
        {
            var mesh:Mesh = new Mesh(geometry, _land.material(color));
            mesh.moveTo(x, y, z);
            mesh.scaleX = scaleX;
            mesh.scaleY = scaleY;
            mesh.scaleZ = scaleZ;
            root.addChild(mesh);
            return mesh;
        }
    }
}
