package starlogo.away3d
{
    import away3d.containers.ObjectContainer3D;
    import away3d.core.base.CompactSubGeometry;
    import away3d.core.base.Geometry;
    import away3d.core.base.ISubGeometry;
    import away3d.core.base.SkinnedSubGeometry;
    import away3d.core.base.SubGeometry;
    import away3d.entities.Mesh;
    import away3d.entities.SegmentSet;
    import away3d.lights.PointLight;
    import away3d.primitives.CapsuleGeometry;
    import away3d.primitives.ConeGeometry;
    import away3d.primitives.CubeGeometry;
    import away3d.primitives.CylinderGeometry;
    import away3d.primitives.PrimitiveBase;
    import away3d.primitives.SphereGeometry;
    import away3d.primitives.TorusGeometry;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.models.ModelError;
    import starlogo.steps.finish;
    import support.Surfaces;
    import support.assertThrows;

    /** Models of what the real Away3D draws. */
    public class Away3dModelTest
    {
        [Test]
        public function primitivesAreClosedAndOutside():void
        {
            assertSolid(new CubeGeometry(2, 3, 4), 8, 12, 2 * 3 * 4, 4);
            assertSolid(new SphereGeometry(1, 16, 12), 2 + 16 * 11, 2 * 16 * 11, 4 / 3 * Math.PI, 2);
            assertSolid(new CylinderGeometry(1, 1, 5, 24), 2 * 24 + 2, 4 * 24, 5 * Math.PI, 2);
            assertSolid(new ConeGeometry(1, 6, 24), 24 + 2, 2 * 24, 2 * Math.PI, 2);
            assertSolid(new TorusGeometry(3, 1, 24, 16), 24 * 16, 2 * 24 * 16, 2 * Math.PI * Math.PI * 3, 8);
            assertSolid(new CapsuleGeometry(1, 2, 16, 15), NaN, NaN, Math.PI * (4 / 3 + 2), 1.989043791);
        }

        private static function assertSolid(geometry:PrimitiveBase, vertices:Number, triangles:Number, volume:Number, width:Number):void
        {
            var name:String = String(geometry);
            var model:Away3dModel = new Away3dModel("solid", geometry);
            assertTrue(name + " is closed", Surfaces.isClosed(model));
            var found:Number = Surfaces.volume(model) * Math.pow(model.width, 3);
            assertTrue(name + " encloses " + found + " of " + volume, found > 0.85 * volume && found < 1.0001 * volume);
            assertEquals(name, width, round(model.width));
            if (!isNaN(vertices))
            {
                assertEquals(name, vertices, model.vertices.length / 3);
                assertEquals(name, triangles, withArea(model));
            }
        }

        private static function withArea(model:Away3dModel):int
        {
            var count:int = 0;
            for (var i:int = 0; i < model.triangles.length; i += 3)
            {
                var a:uint = model.triangles[i];
                var b:uint = model.triangles[i + 1];
                var c:uint = model.triangles[i + 2];
                count += a != b && b != c && a != c ? 1 : 0;
            }
            return count;
        }

        [Test]
        public function upIsUp():void
        {
            var model:Away3dModel = new Away3dModel("plank", new CubeGeometry(2, 3, 4));
            assertEquals("-0.25,-0.5,0,0.25,0.5,0.75", Surfaces.bounds(model.vertices).join());
            assertEquals(4, model.width);
            assertEquals("0,-1.5,0", pointText(model.origin));
        }

        [Test]
        public function originAndWidthSayWhereItIs():void
        {
            var cube:Mesh = new Mesh(new CubeGeometry(2, 2, 2));
            cube.moveTo(10, 20, 30);
            var container:ObjectContainer3D = new ObjectContainer3D();
            container.addChild(cube);
            var model:Away3dModel = new Away3dModel("cube", container);
            assertEquals("10,19,30", pointText(model.origin));
            assertEquals(2, model.width);
        }

        [Test]
        public function theSourcesOwnTransformDoesNotCount():void
        {
            var mesh:Mesh = new Mesh(new CubeGeometry(1, 2, 3));
            var plain:String = textOf(new Away3dModel("cube", mesh));
            mesh.moveTo(1, 2, 3);
            mesh.rotateTo(10, 20, 30);
            mesh.scaleX = -4;
            mesh.pivotPoint = new Vector3D(3, 2, 1);
            assertEquals(plain, textOf(new Away3dModel("cube", mesh)));
            assertEquals(plain, textOf(new Away3dModel("cube", mesh.geometry)));
            assertEquals(plain, textOf(new Away3dModel("cube", mesh.geometry.subGeometries[0])));
            assertEquals(plain, textOf(new Away3dModel("cube", [mesh.geometry])));
        }

        [Test]
        public function everyKindOfSubGeometryReadsAlike():void
        {
            var compact:Geometry = new Geometry();
            compact.addSubGeometry(new SphereGeometry(2, 8, 6).subGeometries[0].clone());
            var expected:String = textOf(new Away3dModel("sphere", compact));

            var separate:Geometry = compact.clone();
            separate.convertToSeparateBuffers();
            assertTrue(separate.subGeometries[0] is SubGeometry);
            assertEquals(3, separate.subGeometries[0].vertexStride);
            assertEquals(expected, textOf(new Away3dModel("sphere", separate)));

            var source:CompactSubGeometry = CompactSubGeometry(compact.subGeometries[0]);
            var skinned:SkinnedSubGeometry = new SkinnedSubGeometry(1);
            skinned.updateData(source.vertexData.concat());
            skinned.updateIndexData(source.indexData.concat());
            assertEquals(expected, textOf(new Away3dModel("sphere", skinned)));

            assertEquals(expected, textOf(new Away3dModel("sphere", OffsetSubGeometry.like(source))));
        }

        [Test]
        public function partsAreTakenTogether():void
        {
            var both:Geometry = new Geometry();
            both.addSubGeometry(new CubeGeometry(1, 1, 1).subGeometries[0].clone());
            both.addSubGeometry(new CubeGeometry(3, 1, 1).subGeometries[0].clone());
            var model:Away3dModel = new Away3dModel("cubes", both);
            assertEquals(16, model.vertices.length / 3);
            assertEquals(24, model.triangles.length / 3);
            assertEquals(3, model.width);
        }

        [Test]
        public function listsOfAnyKindAreTakenTogether():void
        {
            var frames:Vector.<Geometry> = new <Geometry>[new CubeGeometry(1, 1, 1), new CubeGeometry(1, 4, 2)];
            var expected:String = textOf(new Away3dModel("frames", [frames[0], frames[1]]));
            assertEquals(expected, textOf(new Away3dModel("frames", frames)));
            assertEquals(expected, textOf(new Away3dModel("frames", new <Mesh>[new Mesh(frames[0]), new Mesh(frames[1])])));
            var parts:Vector.<ISubGeometry> = frames[0].subGeometries.concat(frames[1].subGeometries);
            assertEquals(expected, textOf(new Away3dModel("frames", parts)));
            assertEquals("-0.25,-0.5,0,0.25,0.5,2", Surfaces.bounds(new Away3dModel("frames", frames).vertices).join());
        }

        [Test]
        public function treesAreAsAway3dPlacesThem():void
        {
            var random:SeededRandom = new SeededRandom(71);
            var mirrored:int = 0;
            var deep:int = 0;
            for (var i:int = 0; i < 60; i++)
            {
                var shared:Geometry = new CubeGeometry(1, 2, 3);
                var root:ObjectContainer3D = new ObjectContainer3D();
                var node:ObjectContainer3D = root;
                var depth:int = random.integer(1, 4);
                for (var level:int = 0; level < depth; level++)
                {
                    var child:ObjectContainer3D = random.chance() || level == depth - 1 ? new Mesh(shared) : new ObjectContainer3D();
                    place(child, random);
                    node.addChild(child);
                    node = child;
                }
                var model:Away3dModel = new Away3dModel("tree", root);
                assertSamePlaces(model, root);
                assertTrue("its outside is outside " + i, Surfaces.volume(model) > 0);
                mirrored += node.sceneTransform.determinant < 0 ? 1 : 0;
                deep += depth > 2 ? 1 : 0;
            }
            assertTrue("mirrored " + mirrored + ", deep " + deep, mirrored > 15 && mirrored < 45 && deep > 10);
        }

        private static function place(object:ObjectContainer3D, random:SeededRandom):void
        {
            object.moveTo(random.between(-5, 5), random.between(-5, 5), random.between(-5, 5));
            object.rotateTo(random.between(-180, 180), random.between(-180, 180), random.between(-180, 180));
            object.scaleX = random.between(0.5, 2) * random.pick([1, -1]);
            object.scaleY = random.between(0.5, 2);
            object.scaleZ = random.between(0.5, 2) * random.pick([1, -1]);
            if (random.chance())
            {
                object.pivotPoint = new Vector3D(random.between(-2, 2), random.between(-2, 2), random.between(-2, 2));
            }
        }

        // Away3D's own matrices say where the meshes' corners are; each is a vertex of the model, and none else is.
        private static function assertSamePlaces(model:Away3dModel, root:ObjectContainer3D):void
        {
            var expected:Vector.<Number> = new Vector.<Number>();
            addCorners(root, expected);
            assertEquals(expected.length, model.vertices.length);
            for (var i:int = 0; i < expected.length; i += 3)
            {
                var nearest:Number = Infinity;
                for (var j:int = 0; j < model.vertices.length; j += 3)
                {
                    nearest = Math.min(nearest, Math.abs(model.vertices[j] * model.width + model.origin.x - expected[i])
                            + Math.abs(model.vertices[j + 2] * model.width + model.origin.y - expected[i + 1])
                            + Math.abs(model.vertices[j + 1] * model.width + model.origin.z - expected[i + 2]));
                }
                assertTrue("a corner is off by " + nearest, nearest < 1e-4);
            }
        }

        private static function addCorners(node:ObjectContainer3D, out:Vector.<Number>):void
        {
            if (node is Mesh)
            {
                for (var i:int = 0; i < 8; i++)
                {
                    var corner:Vector3D = node.sceneTransform.transformVector(new Vector3D(i & 1 ? 0.5 : -0.5, i & 2 ? 1 : -1, i & 4 ? 1.5 : -1.5));
                    out.push(corner.x, corner.y, corner.z);
                }
            }
            for (var child:int = 0; child < node.numChildren; child++)
            {
                addCorners(node.getChildAt(child), out);
            }
        }

        [Test]
        public function aMatrixThatTraitsDoNotSayCounts():void
        {
            var root:ObjectContainer3D = new ObjectContainer3D();
            var child:Mesh = new Mesh(new CubeGeometry(1, 1, 1));
            root.addChild(child);
            // as DAEParser does: sheared, mirrored and moved
            child.transform.rawData = new <Number>[-2, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 7, 0, 0, 1];
            assertEquals(0, child.x);
            var model:Away3dModel = new Away3dModel("sheared", root);
            assertEquals(3, model.width);
            assertEquals("7,-0.5,0", pointText(model.origin));
            assertTrue(Surfaces.volume(model) > 0);
        }

        [Test]
        public function theTraitsArePreciserThanTheMatrix():void
        {
            var root:ObjectContainer3D = new ObjectContainer3D();
            var child:Mesh = new Mesh(new CubeGeometry(1, 1, 1));
            child.x = 1000 + 1e-9;
            root.addChild(child);
            var single:Vector.<Number> = child.transform.rawData;
            single[12] = 1000;
            child.transform.copyRawDataFrom(single);
            assertEquals(1000 + 1e-9, new Away3dModel("cube", root).origin.x);
        }

        [Test]
        public function whatNoTriangleUsesIsLeftOut():void
        {
            var part:SubGeometry = new SubGeometry();
            part.updateVertexData(new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0, 99, 99, 99]);
            part.updateIndexData(new <uint>[0, 1, 2]);
            var model:Away3dModel = new Away3dModel("triangle", part);
            assertEquals(3, model.vertices.length / 3);
            assertEquals(1, model.width);
        }

        [Test]
        public function withoutTrianglesAllVerticesCount():void
        {
            var part:SubGeometry = new SubGeometry();
            part.updateVertexData(new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 4, 0, 0, -0]);
            var model:Away3dModel = new Away3dModel("points", part);
            assertEquals(4, model.vertices.length / 3);
            assertNull(model.triangles);
            assertEquals(4, model.width);
        }

        [Test]
        public function thingsWithoutGeometryAreNothing():void
        {
            var root:ObjectContainer3D = new ObjectContainer3D();
            root.addChild(new Mesh(new CubeGeometry(1, 1, 1)));
            root.addChild(new SegmentSet());
            root.addChild(new PointLight());
            root.addChild(new Mesh(null));
            assertEquals(8, new Away3dModel("cube", root).vertices.length / 3);
        }

        [Test]
        public function whatIsNoModelIsAnError():void
        {
            assertThrows(ModelError, /thing.*expected an ObjectContainer3D.*not null/, make, "thing", null);
            assertThrows(ModelError, /expected an ObjectContainer3D.*not flash.geom.Matrix3D/, make, "thing", new Matrix3D());
            assertThrows(ModelError, /expected an ObjectContainer3D.*not int/, make, "thing", [new CubeGeometry(), 3]);
            assertThrows(ModelError, /thing.*no vertices/, make, "thing", new ObjectContainer3D());
            assertThrows(ModelError, /thing.*no vertices/, make, "thing", []);
            assertThrows(ModelError, /needs a name/, make, "", new CubeGeometry());
            assertThrows(ModelError, /needs a name/, make, null, new CubeGeometry());
        }

        [Test]
        public function brokenGeometryIsAnError():void
        {
            var part:SubGeometry = new SubGeometry();
            part.updateVertexData(new <Number>[0, 0, 0, 1, 0, 0, 0, NaN, 0]);
            part.updateIndexData(new <uint>[0, 1, 2]);
            assertThrows(ModelError, /must be a finite number, not NaN/, make, "thing", part);
            part.updateIndexData(new <uint>[0, 1, 7]);
            assertThrows(ModelError, /triangle 0 .* names vertex 7, the last one is 2/, make, "thing", part);
            part.updateIndexData(new <uint>[0, uint.MAX_VALUE, 2]);
            assertThrows(ModelError, /triangle 0 .* names vertex 4294967295/, make, "thing", part);
            part.updateVertexData(new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0]);
            part.updateIndexData(new <uint>[0, 1, 2]);
            part.vertexData.length = 8;
            assertThrows(ModelError, /3 vertices, but only 8 numbers/, make, "thing", part);
            var offset:OffsetSubGeometry = OffsetSubGeometry.like(CompactSubGeometry(new CubeGeometry(1, 1, 1).subGeometries[0]));
            offset.vertexData.fixed = false;
            // enough if the first vertex began at the first number
            offset.vertexData.length = 23 * 13 + 3;
            assertThrows(ModelError, /24 vertices, but only 302 numbers/, make, "thing", offset);
            offset.vertexData.length = 23 * 13 + 5;
            assertEquals(1, make("thing", offset).width);
        }

        private static function make(name:String, source:Object):Away3dModel
        {
            return new Away3dModel(name, source);
        }

        [Test]
        public function inStepsItIsTheSame():void
        {
            var source:Geometry = new SphereGeometry(1, 80, 60);
            var reader:Away3dModelReader = new Away3dModelReader("sphere", [source, new CubeGeometry(3, 1, 1)]);
            assertEquals("sphere", reader.name);
            assertEquals(0, reader.progress);
            assertNull(reader.model);
            var steps:int = 1;
            var last:Number = 0;
            while (reader.step())
            {
                steps++;
                assertTrue(reader.progress >= last && reader.progress < 1);
                last = reader.progress;
            }
            assertTrue("in steps: " + steps, steps > 25);
            assertEquals(1, reader.progress);
            assertEquals(textOf(new Away3dModel("sphere", [source, new CubeGeometry(3, 1, 1)])), textOf(Away3dModel(reader.model)));
        }

        [Test]
        public function aReaderSaysWhatIsWrong():void
        {
            var reader:Away3dModelReader = new Away3dModelReader("thing", new Matrix3D());
            assertThrows(ModelError, /thing.*expected an ObjectContainer3D/, finish, reader);
        }

        private static function textOf(model:Away3dModel):String
        {
            assertFalse(model.triangles == null);
            return [model.name, model.vertices, model.triangles, pointText(model.origin), model.width].join("|");
        }

        private static function pointText(point:Vector3D):String
        {
            return [point.x, point.y, point.z].join();
        }

        private static function round(number:Number):Number
        {
            return Math.round(number * 1e9) / 1e9;
        }
    }
}

import away3d.core.base.CompactSubGeometry;

/** Vertices that do not begin at the data's first number. */
class OffsetSubGeometry extends CompactSubGeometry
{
    public static function like(source:CompactSubGeometry):OffsetSubGeometry
    {
        var data:Vector.<Number> = source.vertexData.concat();
        // each vertex moves on by two numbers, into what followed it
        for (var i:int = data.length - 13; i >= 0; i -= 13)
        {
            data[i + 4] = data[i + 2];
            data[i + 3] = data[i + 1];
            data[i + 2] = data[i];
            data[i] = data[i + 1] = NaN;
        }
        var made:OffsetSubGeometry = new OffsetSubGeometry();
        made.updateData(data);
        made.updateIndexData(source.indexData.concat());
        return made;
    }

    override public function get vertexOffset():int
    {
        return 2;
    }
}
