package client
{
    import away3d.cameras.lenses.PerspectiveLens;
    import away3d.containers.ObjectContainer3D;
    import away3d.containers.View3D;
    import away3d.core.base.Geometry;
    import away3d.core.base.Object3D;
    import away3d.entities.Mesh;
    import away3d.lights.DirectionalLight;
    import away3d.materials.ColorMaterial;
    import away3d.materials.MaterialBase;
    import away3d.materials.SinglePassMaterialBase;
    import away3d.materials.TextureMaterial;
    import away3d.materials.lightpickers.StaticLightPicker;
    import away3d.materials.methods.FogMethod;
    import away3d.primitives.PlaneGeometry;
    import away3d.primitives.RegularPolygonGeometry;
    import away3d.textures.BitmapTexture;
    import flash.display.BitmapData;
    import flash.display.Sprite;
    import flash.geom.Rectangle;
    import flash.geom.Vector3D;

    /** The land as Away3D draws it: the ground of SpaceLand, light, air and a camera. Its objects are placed in patches, y up. */
    public final class Land extends Sprite
    {
        private static const WIDTH:Number = 101;
        private static const SURROUNDINGS:Number = 500;
        private static const SKY:uint = 0xbfe0f2;
        private static const GRASS:Array = [0x79b356, 0x73ac52, 0x7db85a, 0x70a850];

        private var _view:View3D = new View3D();
        private var _lights:StaticLightPicker;
        private var _fog:FogMethod = new FogMethod(60, 220, SKY);
        private var _materials:Object = {};
        private var _shadow:Geometry = new RegularPolygonGeometry(0.5, 24);
        private var _shade:ColorMaterial = new ColorMaterial(0x12300c, 0.3);

        /** Creates an empty land. */
        public function Land()
        {
            _view.backgroundColor = SKY;
            _view.antiAlias = 4;
            _view.camera.lens = new PerspectiveLens(50);
            _view.camera.lens.near = 0.5;
            _view.camera.lens.far = 600;
            addChild(_view);
            var sun:DirectionalLight = new DirectionalLight(0.5, -1, 0.35);
            sun.color = 0xfff3dc;
            sun.diffuse = 0.85;
            sun.specular = 0.15;
            sun.ambientColor = 0xd5e6ff;
            sun.ambient = 0.5;
            _view.scene.addChild(sun);
            _lights = new StaticLightPicker([sun]);
            addGround();
        }

        /** Sets the view's size, in pixels. */
        public function resize(width:Number, height:Number):void
        {
            _view.width = width;
            _view.height = height;
        }

        /** Adds an object. */
        public function show(object:ObjectContainer3D):void
        {
            _view.scene.addChild(object);
        }

        /** Removes an object. */
        public function hide(object:ObjectContainer3D):void
        {
            _view.scene.removeChild(object);
        }

        /** The material of a colour. The same colour always gives the same material. */
        public function material(color:uint):MaterialBase
        {
            if (_materials[color] == null)
            {
                _materials[color] = new ColorMaterial(color);
                light(_materials[color]);
            }
            return _materials[color];
        }

        /** A shadow on the ground, one patch wide. */
        public function newShadow():Mesh
        {
            return new Mesh(_shadow, _shade);
        }

        /** Gives a material the land's light and air. Both sides of it are drawn, because some files mirror their parts. */
        public function light(material:MaterialBase):void
        {
            var lit:SinglePassMaterialBase = material as SinglePassMaterialBase;
            if (lit != null && lit.lightPicker != _lights)
            {
                lit.lightPicker = _lights;
                lit.addMethod(_fog);
                lit.bothSides = true;
                lit.gloss = 12;
            }
        }

        /** Moves the camera a part of the way to a place, and turns it to another. Both places are in the agents' axes, z up. */
        public function look(fromX:Number, fromY:Number, fromZ:Number, atX:Number, atY:Number, atZ:Number, part:Number):void
        {
            var camera:Object3D = _view.camera;
            camera.moveTo(camera.x + part * (fromX - camera.x), camera.y + part * (fromZ - camera.y), camera.z + part * (fromY - camera.z));
            camera.lookAt(new Vector3D(atX, atZ, atY));
        }

        /** Draws a frame. */
        public function draw():void
        {
            _view.render();
        }

        private function addGround():void
        {
            var patches:BitmapData = new BitmapData(256, 256, false);
            for (var i:int = 0; i < 64; i++)
            {
                patches.fillRect(new Rectangle(i % 8 * 32, int(i / 8) * 32, 32, 32), GRASS[i * 7 % 5 % 2 + (i % 8 + int(i / 8)) % 2 * 2]);
            }
            var grass:TextureMaterial = new TextureMaterial(new BitmapTexture(patches), true, true, true);
            light(grass);
            grass.specular = 0;
            var field:PlaneGeometry = new PlaneGeometry(WIDTH, WIDTH);
            field.scaleUV(WIDTH / 8, WIDTH / 8);
            show(new Mesh(field, grass));

            var meadow:ColorMaterial = new ColorMaterial(0x6a9e4d);
            light(meadow);
            meadow.specular = 0;
            var around:Mesh = new Mesh(new PlaneGeometry(SURROUNDINGS, SURROUNDINGS), meadow);
            around.y = -0.3;
            show(around);
        }
    }
}
