package starlogo.away3d
{
    import away3d.bounds.AxisAlignedBoundingBox;
    import away3d.bounds.BoundingVolumeBase;
    import away3d.containers.ObjectContainer3D;
    import away3d.core.base.Geometry;
    import away3d.core.base.ISubGeometry;
    import away3d.core.base.Object3D;
    import away3d.core.base.SubGeometry;
    import away3d.entities.Entity;
    import away3d.entities.Mesh;
    import away3d.entities.SegmentSet;
    import away3d.materials.MaterialBase;
    import away3d.primitives.LineSegment;
    import away3d.primitives.data.Segment;
    import flash.display.Loader;
    import flash.events.Event;
    import flash.system.ApplicationDomain;
    import flash.system.LoaderContext;
    import flash.utils.describeType;
    import flash.utils.getQualifiedClassName;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.async.Async;
    import support.Fixtures;

    /** What lib/away3d-api declares of Away3D is so in the real one. */
    public class Away3dDeclarationsTest
    {
        public static const FIXTURES:Array = ["/away3d-api/library.swf"];

        private static const CLASSES:Array = [AxisAlignedBoundingBox, BoundingVolumeBase, ObjectContainer3D, Geometry, ISubGeometry, Object3D, Entity, Mesh,
                SegmentSet, MaterialBase, LineSegment, Segment, SubGeometry];

        [Test(async, timeout="150000")]
        public function declarationsAreAsTheRealThing():void
        {
            var loader:Loader = new Loader();
            loader.contentLoaderInfo.addEventListener(Event.COMPLETE, Async.asyncHandler(this, function(event:Event, data:Object):void
                    {
                        compareAll(loader.contentLoaderInfo.applicationDomain);
                    }, 120000));
            // a domain of its own: the names are the same
            loader.loadBytes(Fixtures.bytes("/away3d-api/library.swf"), new LoaderContext(false, new ApplicationDomain(null)));
        }

        private static function compareAll(declarations:ApplicationDomain):void
        {
            var members:int = 0;
            for each (var real:Class in CLASSES)
            {
                var name:String = getQualifiedClassName(real);
                var declared:Class = Class(declarations.getDefinition(name));
                assertFalse(name + " is in a domain of its own", declared == real);
                members += compare(name, describeType(declared).factory[0], describeType(real).factory[0]);
            }
            assertEquals("members that are compared", 37, members);
        }

        private static function compare(owner:String, declared:XML, real:XML):int
        {
            assertEquals(owner, parametersOf(real), parametersOf(declared));
            assertEquals(owner, "", missing(declared.extendsClass.@type, real.extendsClass.@type));
            var count:int = 0;
            for each (var accessor:XML in declared.accessor.(@declaredBy == owner))
            {
                var found:XMLList = real.accessor.(@name == accessor.@name);
                // one that a superclass has and an interface names may be listed twice
                assertTrue(owner + "." + accessor.@name, found.length() > 0);
                assertEquals(owner + "." + accessor.@name, accessor.@type, found[0].@type);
                assertTrue(owner + "." + accessor.@name, found[0].@access == "readwrite" || found[0].@access == accessor.@access);
                count++;
            }
            for each (var method:XML in declared.method.(@declaredBy == owner))
            {
                found = real.method.(@name == method.@name);
                assertEquals(owner + "." + method.@name, 1, found.length());
                assertEquals(owner + "." + method.@name, method.@returnType + parametersOf(method), found.@returnType + parametersOf(found[0]));
                count++;
            }
            return count;
        }

        private static function parametersOf(callable:XML):String
        {
            var parameters:XMLList = callable.constructor.length() > 0 ? callable.constructor.parameter : callable.parameter;
            var list:Array = [];
            for each (var parameter:XML in parameters)
            {
                list.push(parameter.@type + (parameter.@optional == "true" ? "?" : ""));
            }
            return list.join();
        }

        private static function missing(names:XMLList, of:XMLList):String
        {
            var others:Array = [];
            for each (var other:XML in of)
            {
                others.push(String(other));
            }
            var list:Array = [];
            for each (var each:XML in names)
            {
                if (others.indexOf(String(each)) < 0)
                {
                    list.push(String(each));
                }
            }
            return list.join();
        }
    }
}
